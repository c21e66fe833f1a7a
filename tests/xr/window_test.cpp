#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "engine/vr/graphics_binding.h"
#include "engine/window.h"
#include "tests/xr/monado.h"
#include "tests/xr/program.h"

#include <catch2/catch_test_macros.hpp>

#include <fstream>
#include <iterator>

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct WindowFlight {
    WindowFlight() {
        std::ofstream(scenario) << "title = \"nothing at all\"\n[vehicle]\nmaximum_acceleration = [1.0, 1.0, 1.0]\n";
        std::ofstream(script) << "duration,ax,ay,az,wx,wy,wz\n60,0,0,-0.1,0,0,0\n";
    }

    std::vector<std::string> words(const std::string& seconds) const {
        return {"fly",    scenario.string(), "--vr",      "--script", script.string(), "--record", recording.string(),
                "--size", "320x180",         "--seconds", seconds};
    }

    const xr_kit::Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    const fs::path script = folder.path / "thrust.csv";
    const fs::path recording = folder.path / "f.rapidity";
};

} // namespace

TEST_CASE("a window under X mirrors the headset, and the validation layer has nothing to say of the whole session") {
    xr_kit::use_simulated_headset();
    const WindowFlight flight;
    const fs::path log = flight.folder.path / "validation.txt";
    const std::map<std::string, std::string> validation{{"XR_ENABLE_API_LAYERS", "XR_APILAYER_LUNARG_core_validation"},
                                                        {"XR_CORE_VALIDATION_EXPORT_TYPE", "text"},
                                                        {"XR_CORE_VALIDATION_FILE_NAME", log.string()},
                                                        {"XR_LOADER_DEBUG", "info"}};
    const xr_kit::Run run = xr_kit::run_program_in_window(flight.words("4"), validation);
    const std::string said = contents(log);
    INFO(run.output << said);
    CHECK(run.exit_code == 0);
    CHECK(xr_kit::count(run.output, "headset: Monado") == 1);
    CHECK(xr_kit::count(run.output, "headset lost") == 0);
    // Later layers also say that they begin and end (VALID_DEBUG).
    for (const std::string severity : {"VALID_ERROR", "VALID_WARNING"}) {
        CHECK(xr_kit::count(said, severity) == 0);
    }
    const engine::Recording recording = engine::read_recording(flight.recording);
    CHECK(recording.ending.has_value());
    CHECK(recording.frames.size() > 5);
    CHECK_NOTHROW(engine::fly_again(recording));
    // The loader says that the layer was there.
    CHECK(xr_kit::count(run.output, "succeeded loading layer XR_APILAYER_LUNARG_core_validation") >= 1);
}

TEST_CASE("a headset that is lost leaves the flight in the window, and is picked up again") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("lose_session=5");
    const WindowFlight flight;
    const xr_kit::Run run = xr_kit::run_program_in_window(flight.words("5"));
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(xr_kit::count(run.output, "headset lost (") == 1);
    CHECK(xr_kit::count(run.output, "headset: Monado") == 2);
    const engine::Recording recording = engine::read_recording(flight.recording);
    CHECK(recording.ending.has_value());
    // It flew on while there was no headset: more ticks lie between two frames than any frame takes.
    sim::Tick longest = 0;
    for (std::size_t i = 1; i < recording.frames.size(); ++i) {
        longest = std::max(longest, recording.frames[i].tick - recording.frames[i - 1].tick);
    }
    CHECK(longest > 120);
    CHECK_NOTHROW(engine::fly_again(recording));
}

TEST_CASE("without a headset the window flies") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("no_headset=1000");
    const WindowFlight flight;
    const xr_kit::Run run = xr_kit::run_program_in_window(flight.words("1"));
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(xr_kit::count(run.output, "no headset here (the OpenXR runtime finds no headset): flying in the window") ==
          1);
    CHECK(engine::read_recording(flight.recording).ending.has_value());
}

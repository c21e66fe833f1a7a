#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "input/xr_failure.h"
#include "input/xr_library.h"
#include "tests/xr/monado.h"
#include "tests/xr/program.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <fstream>

namespace {

namespace fs = std::filesystem;

/// A world without anything in it, and a second of thrust, for flights of which only the end counts.
struct ShortFlight {
    ShortFlight() {
        std::ofstream(scenario) << "title = \"nothing at all\"\n"
                                   "[vehicle]\nmaximum_acceleration = [1.0, 1.0, 1.0]\n"
                                   "maximum_turn_rate = [1.0, 1.0, 1.0]\n";
        std::ofstream(script) << "duration,ax,ay,az,wx,wy,wz\n1,0,0,-0.5,0,0,0\n";
    }

    std::vector<std::string> words(const std::string& seconds) const {
        return {"fly",      scenario.string(),  "--vr",      "--headless", "--script", script.string(),
                "--record", recording.string(), "--seconds", seconds};
    }

    const xr_kit::Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    const fs::path script = folder.path / "thrust.csv";
    const fs::path recording = folder.path / "f.rapidity";
};

/// The flight went on without a headset: one line says why, and all of it is recorded.
void check_flown_without(const std::string& why, const std::map<std::string, std::string>& environment) {
    const ShortFlight flight;
    const xr_kit::Run run = xr_kit::run_program(flight.words("1"), environment);
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(xr_kit::count(run.output, "no headset here (") == 1);
    CHECK(run.output.find(why) != std::string::npos);
    CHECK(xr_kit::count(run.output, "OpenXR-Loader") == 0); // the loader's own complaints are not the pilot's
    const engine::Recording recording = engine::read_recording(flight.recording);
    CHECK(recording.ending.has_value());
    CHECK(recording.end() == 240);
}

} // namespace

TEST_CASE("without OpenXR's loader one line says so, and the flight goes on") {
    const xr_kit::Folder folder;
    std::ofstream(folder.path / "libopenxr_loader.so.1") << "no library";
    check_flown_without("the OpenXR loader cannot be opened", {{"LD_LIBRARY_PATH", folder.path.string()}});
    // The library that is opened is the one asked for.
    CHECK_THROWS_AS(input::XrLibrary((folder.path / "libopenxr_loader.so.1").string()), input::XrFailure);
}

TEST_CASE("without a runtime one line says so, and the flight goes on") {
    check_flown_without("no OpenXR runtime can be loaded", {{"XR_RUNTIME_JSON", "/there/is/none.json"}});
}

TEST_CASE("with a broken runtime manifest one line says so, and the flight goes on") {
    const xr_kit::Folder folder;
    const fs::path manifest = folder.path / "broken.json";
    std::ofstream(manifest) << "{\"file_format_version\": ";
    check_flown_without("no OpenXR runtime can be loaded", {{"XR_RUNTIME_JSON", manifest.string()}});
}

TEST_CASE("with a runtime without OpenGL one line says so, and the flight goes on") {
    check_flown_without("does not take OpenGL pictures", {{"XR_RUNTIME_JSON", RAPIDITY_POOR_RUNTIME}});
}

TEST_CASE("without a headset one line says so, and the flight goes on") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("no_headset=1000");
    check_flown_without("finds no headset", {});
}

TEST_CASE("with a headset of no views one line says so, and the flight goes on") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("no_views=1");
    check_flown_without("shows 0 views", {});
}

TEST_CASE("the runtime's own menu ends the flight cleanly, with the recording complete") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("stop=10");
    const ShortFlight flight;
    const xr_kit::Run run = xr_kit::run_program(flight.words("60"));
    INFO(run.output);
    CHECK(run.exit_code == 0);
    CHECK(xr_kit::count(run.output, "the headset ends the flight") == 1);
    const engine::Recording recording = engine::read_recording(flight.recording);
    CHECK(recording.ending.has_value());
    CHECK(recording.end() > 0);
    CHECK_NOTHROW(engine::fly_again(recording));
}

TEST_CASE("a lost session, a session or a runtime about to go: the flight waits, the headset is found again") {
    for (const std::string fault : {"lose_session=10", "lose_session_soon=10", "lose_instance_soon=10 away=1"}) {
        CAPTURE(fault);
        xr_kit::use_simulated_headset();
        xr_kit::use_faults(fault);
        const ShortFlight flight;
        const xr_kit::Run run = xr_kit::run_program(flight.words("1.5"));
        INFO(run.output);
        CHECK(run.exit_code == 0);
        CHECK(xr_kit::count(run.output, "headset lost (") == 1);
        CHECK(xr_kit::count(run.output, "headset: Monado") == 2);
        const engine::Recording recording = engine::read_recording(flight.recording);
        CHECK(recording.ending.has_value());
        // A second and a half, but for what a busy machine's late frames leave unflown.
        CHECK(recording.end() >= 240);
        CHECK_NOTHROW(engine::fly_again(recording));
    }
}

TEST_CASE("where tracking is lost the head's last place is held, at rest, and the pictures are dimmed") {
    xr_kit::use_simulated_headset();
    xr_kit::use_faults("untracked=15 untracked_frames=20");
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(0.5f), glm::vec3(0.5f), glm::vec3(0.5f)};
    xr_kit::WatchedFlight flight(scene);
    std::vector<std::string> notes;
    std::optional<engine::HeadsetFrame> before;
    int brightest = 0;
    int dimmest = 255;
    for (int i = 0; i < 60; ++i) {
        const std::optional<engine::HeadsetFrame> frame = flight.next_frame();
        REQUIRE(frame);
        for (const std::string& note : flight.headset.take_notes()) {
            notes.push_back(note);
        }
        if (frame->shown) {
            const content::Image image = flight.headset.pictures().picture(0).read();
            const int level =
                image.rgba[4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height / 2)];
            brightest = std::max(brightest, level);
            dimmest = std::min(dimmest, level);
        }
        const sim::ControlFrame& control = flight.flight.control();
        if (flight.headset.tracking_lost()) {
            CHECK(control.head_velocity == glm::dvec3(0.0));
            CHECK(glm::length(frame->head.place.position) < 1.0);
            if (before && !before->head.tracked) {
                CHECK(frame->head.place.position == before->head.place.position);
                CHECK(frame->head.place.orientation == before->head.place.orientation);
            }
        }
        before = frame;
    }
    CHECK(std::ranges::count(notes, "the headset's tracking is lost: the last place of the head is held") == 1);
    CHECK(std::ranges::count(notes, "the headset is tracked again") == 1);
    CHECK_FALSE(flight.headset.tracking_lost());
    // A second after the loss a fifth of the light is left: 92 of sRGB's levels of 188.
    CHECK(dimmest < 0.6 * brightest);
}

TEST_CASE("controllers that go away leave the ship without thrust") {
    xr_kit::RemoteHeadset remote;
    xr_kit::use_faults("no_controllers=60");
    content::Scenario scenario;
    scenario.vehicle.maximum_acceleration = glm::dvec3(1.0);
    xr_kit::WatchedFlight flight({}, scenario);
    remote.right.trigger = 1.0F;
    double most = 0.0;
    for (int i = 0; i < 100; ++i) {
        remote.send();
        const std::optional<engine::HeadsetFrame> frame = flight.next_frame();
        REQUIRE(frame);
        most = std::max(most, -flight.flight.control().proper_acceleration.z);
        if (i >= 60) {
            CHECK_FALSE(frame->controllers.gamepad.has_value());
        }
    }
    CHECK(most > 0.9);
    CHECK(flight.flight.control().proper_acceleration == glm::dvec3(0.0));
}

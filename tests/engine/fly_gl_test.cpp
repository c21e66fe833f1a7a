#include "content/generator/cabin.h"
#include "engine/cockpit/cockpit.h"
#include "engine/film.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "tests/engine/command.h"
#include "tests/engine/png_text.h"
#include "tests/paths.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

class Folder {
  public:
    Folder() : path(fs::temp_directory_path() / ("rapidity-fly-gl-" + std::to_string(std::random_device()()))) {
        fs::create_directories(path);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::vector<fs::path> files(const std::string& extension) const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(path)) {
            if (entry.path().extension() == extension) {
                found.push_back(entry.path());
            }
        }
        return found;
    }

    const fs::path path;
};

using tests::contents;

/// Width and height from a PNG's header chunk.
std::pair<int, int> png_size(const fs::path& file) {
    const std::string bytes = contents(file);
    REQUIRE(bytes.size() > 24);
    REQUIRE(bytes.substr(1, 3) == "PNG");
    const auto number = [&bytes](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
        }
        return value;
    };
    return {number(16), number(20)};
}

constexpr const char* empty_world = "title = \"nothing at all\"\n"
                                    "[vehicle]\nmaximum_acceleration = [1.0, 1.0, 1.0]\n"
                                    "maximum_turn_rate = [1.0, 1.0, 1.0]\n";

using tests::rapidity;

} // namespace

TEST_CASE("a demonstration leaves a recording, stills and, with ffmpeg, a film") {
    const Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    std::ofstream(scenario) << empty_world;
    REQUIRE(rapidity({"fly", scenario.string(), "--demonstration", folder.path.string(), "--size", "161x90", "--fps",
                      "10", "--seconds", "2"}) == 0);
    REQUIRE(folder.files(".rapidity").size() == 1);
    CHECK(engine::read_recording(folder.files(".rapidity").front()).end() == 480);
    const std::vector<fs::path> stills = folder.files(".png");
    CHECK(stills.size() == 8);
    for (const fs::path& still : stills) {
        CHECK(png_size(still) == std::pair(161, 90));
        const std::string bytes = contents(still);
        CHECK(tests::png_text(bytes, "scenario") == "empty");
        CHECK(tests::png_text(bytes, "mode") == "full");
        CHECK(std::stod(tests::png_text(bytes, "event_time_seconds")) >= 0.0);
    }
    const std::size_t films = engine::program_on_path("ffmpeg").empty() ? 0 : 1;
    REQUIRE(folder.files(".mp4").size() == films);
    if (films == 1) {
        CHECK(contents(folder.files(".mp4").front()).substr(4, 4) == "ftyp");
    }
}

TEST_CASE("pictures that cannot be written do not stop the flight") {
    const Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    std::ofstream(scenario) << empty_world;
    std::ofstream(folder.path / "file") << "in the way of a folder";
    CHECK(rapidity({"fly", scenario.string(), "--headless", "--record", (folder.path / "f.rapidity").string(),
                    "--stills", (folder.path / "file/stills").string(), "--film",
                    (folder.path / "file/film.mp4").string(), "--size", "64x36", "--fps", "2", "--seconds", "2"}) == 0);
    CHECK(engine::read_recording(folder.path / "f.rapidity").end() == 480);
}

TEST_CASE("a scripted keyboard flies the window") {
    if (engine::program_on_path("Xvfb").empty() || engine::program_on_path("xdotool").empty()) {
        FAIL("needs Xvfb and xdotool, which ./check installs");
    }
    const Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    std::ofstream(scenario) << empty_world;
    const std::string command = tests::source_folder() + "/tests/engine/fly_window.sh " + tests::program() + " " +
                                scenario.string() + " " + folder.path.string();
    REQUIRE(std::system(command.c_str()) == 0);

    const fs::path recording = folder.path / "f.rapidity";
    REQUIRE(fs::exists(recording));
    const engine::Recording read = engine::read_recording(recording);
    CHECK(read.ending.has_value()); // quit by its key, closed properly
    bool thrust_ahead = false;
    bool turned_left = false;
    for (const auto& timed : read.controls) {
        thrust_ahead = thrust_ahead || timed.control.proper_acceleration.z < -0.9;
        turned_left = turned_left || timed.control.angular_velocity.y > 0.5;
    }
    CHECK(thrust_ahead);
    CHECK(turned_left);
    CHECK_NOTHROW(engine::fly_again(read)); // what the window flew is what the demands say

    for (const char* name : {"f-1.png", "f-2.png"}) {
        REQUIRE(fs::exists(folder.path / name));
        CHECK(png_size(folder.path / name) == std::pair(640, 360));
    }
    // Each key was heard once, and undone by the second time around.
    const std::string analysed = contents(folder.path / "f-1.png");
    CHECK(tests::png_text(analysed, "view") == "luminance");
    CHECK(tests::png_text(analysed, "panes") == "everything: luminance, geometry only, geometry and Doppler, "
                                                "geometry and searchlight");
    CHECK(std::stod(tests::png_text(analysed, "bloom")) > 0.0);
    CHECK(std::stod(tests::png_text(analysed, "beta")) > 0.0);
    const std::string natural = contents(folder.path / "f-2.png");
    CHECK(tests::png_text(natural, "view") == "natural");
    CHECK(natural.find("rapidity:panes") == std::string::npos);
    CHECK(tests::png_text(natural, "bloom") == "0");
    const std::string output = contents(folder.path / "output.txt");
    CHECK(output.find("flew empty") != std::string::npos);
    CHECK(output.find("rapidity 0.0000") == std::string::npos); // the thrust key gave it speed
}

TEST_CASE("a mouse works the cockpit's screens, and a demonstration returns to its start with a recording of its own") {
    if (engine::program_on_path("Xvfb").empty() || engine::program_on_path("xdotool").empty()) {
        FAIL("needs Xvfb and xdotool, which ./check installs");
    }
    const Folder folder;
    const fs::path scenario = folder.path / "empty.toml";
    std::ofstream(scenario) << empty_world;
    fs::create_directories(folder.path / "flights");

    // Where a window of 640x360 shows the button "geometry" of the right screen: that of the panel's own test.
    const content::generator::Cabin cabin = content::generator::make_cabin();
    const content::generator::PanelScreen& screen = cabin.screens[2];
    const glm::dvec2 share(44.0 / 306.0, 48.0 / 162.0);
    const glm::dvec3 point = screen.centre + (2.0 * share.x - 1.0) * screen.right + (1.0 - 2.0 * share.y) * screen.up;
    render::EyeView eye;
    eye.width = 640;
    eye.height = 360;
    const render::CabinView view = engine::cabin_view(eye, {}, {1.0, 0.0, 0.0, 0.0});
    const glm::dvec2 place = view.place_of(view.tangents_of(point));
    const std::string command = tests::source_folder() + "/tests/engine/fly_cockpit.sh " + tests::program() + " " +
                                scenario.string() + " " + folder.path.string() + " " +
                                std::to_string(std::lround(640.0 * place.x)) + " " +
                                std::to_string(std::lround(360.0 * (1.0 - place.y)));
    REQUIRE(std::system(command.c_str()) == 0);

    CHECK(tests::png_text(contents(folder.path / "c-1.png"), "mode") == "full");
    CHECK(tests::png_text(contents(folder.path / "c-2.png"), "mode") == "geometry");
    // A press on a screen steers nothing; a step's key, and the key that turns left once, turn by 45 degrees each.
    const engine::Recording flown = engine::read_recording(folder.path / "c.rapidity");
    int steps = 0;
    double turned = 0.0;
    for (const auto& timed : flown.controls) {
        steps += timed.control.has(sim::ControlFrame::snap_turn) ? 1 : 0;
        turned += timed.control.angular_velocity.y / 240.0 * 180.0 / std::acos(-1.0);
    }
    CHECK(steps == 2);
    CHECK(std::abs(turned - 90.0) < 1e-6);
    CHECK_NOTHROW(engine::fly_again(flown));

    std::vector<fs::path> flights;
    for (const auto& entry : fs::directory_iterator(folder.path / "flights")) {
        if (entry.path().extension() == ".rapidity") {
            flights.push_back(entry.path());
        }
        CHECK(entry.path().extension() != ".png"); // screenshots are locked
    }
    REQUIRE(flights.size() == 2); // touched, and the one that began when nobody touched anything any more
    std::sort(flights.begin(), flights.end());
    double fastest = 0.0;
    for (const fs::path& file : flights) {
        const engine::Recording read = engine::read_recording(file);
        CHECK(read.ending.has_value());
        for (const auto& timed : read.controls) {
            fastest = std::max(fastest, std::abs(timed.control.proper_acceleration.z));
        }
    }
    CHECK(fastest > 0.9);
    CHECK(contents(folder.path / "demo.txt").find("flew empty") != std::string::npos);
}

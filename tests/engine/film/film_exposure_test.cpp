#include "engine/film/exposure_log.h"
#include "engine/film/film_maker.h"

#include "../png_text.h"
#include "../recorded_flight.h"
#include "render/shown_picture.h"
#include "sim/bad_input.h"
#include "sim/look.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <string>

using Catch::Matchers::WithinAbs;

namespace {

constexpr double frames_per_second = 5.0;

/// An empty place under a sky whose top is many stops brighter than its bottom.
content::Scenario bright_above() {
    content::Scenario scenario = recorded_flight::scenario();
    scenario.gradient_sky.zenith = glm::vec3(8.0f);
    scenario.gradient_sky.horizon = glm::vec3(0.5f);
    scenario.gradient_sky.nadir = glm::vec3(0.01f);
    return scenario;
}

render::RenderFrame looking(const content::Scenario& scenario, bool up, const engine::FilmRequest& request) {
    render::RenderFrame frame;
    frame.eye.width = request.size.width;
    frame.eye.height = request.size.height;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(0.0), {0.0, 0.0, -1.0}, {0.0, up ? 1.0 : -1.0, 0.0});
    frame.exposure = engine::film_settings(scenario, request).exposure;
    return frame;
}

/// The eye looks down for two frames, up for three, and down again: nine frames.
engine::FilmReel nodding(const content::Scenario& scenario, const engine::FilmRequest& request) {
    return {"nodding\n", 9, [scenario, request](std::size_t frame) {
                return engine::FilmShot{looking(scenario, frame >= 2 && frame < 5, request), {{"scenario", "nod"}}};
            }};
}

engine::FilmRequest request_for(const std::filesystem::path& frames) {
    engine::FilmRequest request;
    request.frames = frames;
    request.size = {32, 32};
    request.frames_per_second = frames_per_second;
    request.method = engine::PictureMethod::ray;
    request.samples_per_side = 1;
    return request;
}

std::filesystem::path frame(const std::filesystem::path& folder, int number) {
    return folder / ("frame-00000" + std::to_string(number) + ".png");
}

double stops(const std::filesystem::path& folder, int number) {
    return std::stod(tests::png_text(tests::contents(frame(folder, number)), "exposure_stops"));
}

} // namespace

TEST_CASE(
    "a film's exposure follows its light as an eye adapts: by e in a quarter of a second to bright, 0.7 to dark") {
    const recorded_flight::Folder folder;
    const content::Scenario scenario = bright_above();
    const engine::FilmRequest request = request_for(folder / "film");
    engine::make_film(scenario, nodding(scenario, request), request);

    // What each of the two pictures settles at, from pictures of their own.
    const auto settled = [&](bool up) {
        engine::FilmRequest still = request_for(folder / (up ? "up" : "down"));
        engine::make_film(scenario,
                          {"one\n", 1,
                           [&](std::size_t) {
                               return engine::FilmShot{looking(scenario, up, still), {}};
                           }},
                          still);
        return stops(still.frames, 1);
    };
    const double dark = settled(false);
    const double bright = settled(true);
    REQUIRE(dark - bright > 3.0); // stops: there is something to adapt to
    double expected = dark;
    for (int number = 1; number <= 9; ++number) {
        const bool up = number >= 3 && number <= 5;
        if (number > 1) {
            const double target = up ? bright : dark;
            expected = target + (expected - target) * std::exp(-1.0 / (frames_per_second * (up ? 0.25 : 0.7)));
        }
        INFO("frame " << number);
        // Single-precision light: its luminance is off by some 1e-7, the stops of it by as much.
        CHECK_THAT(stops(folder / "film", number), WithinAbs(expected, 1e-6));
    }
}

TEST_CASE("a film that was interrupted anywhere goes on to the bytes of one that was not") {
    const recorded_flight::Folder folder;
    const content::Scenario scenario = bright_above();
    const engine::FilmRequest whole = request_for(folder / "whole");
    const engine::FilmReel reel = nodding(scenario, whole);
    engine::make_film(scenario, reel, whole);

    const engine::FilmRequest other = request_for(folder / "other");
    const auto goes_on_the_same = [&] {
        engine::make_film(scenario, reel, other);
        for (int number = 1; number <= 9; ++number) {
            INFO("frame " << number);
            CHECK(tests::contents(frame(other.frames, number)) == tests::contents(frame(whole.frames, number)));
        }
        CHECK(tests::contents(other.frames / "exposure.csv") == tests::contents(whole.frames / "exposure.csv"));
    };
    const auto copy = [&](std::uintmax_t log_bytes, int frames) {
        std::filesystem::remove_all(other.frames);
        std::filesystem::copy(whole.frames, other.frames);
        std::filesystem::resize_file(other.frames / "exposure.csv", log_bytes);
        for (int number = frames + 1; number <= 9; ++number) {
            std::filesystem::remove(frame(other.frames, number));
        }
    };
    const std::string log = tests::contents(whole.frames / "exposure.csv");
    std::size_t four_lines = 0;
    for (int line = 0; line < 4; ++line) {
        four_lines = log.find('\n', four_lines) + 1;
    }
    copy(four_lines, 4); // between two frames
    goes_on_the_same();
    copy(four_lines, 3); // metered, not written
    goes_on_the_same();
    copy(four_lines + 5, 4); // part of a line
    goes_on_the_same();
    copy(0, 4); // a log that was lost
    goes_on_the_same();
    copy(log.size(), 9);
    std::filesystem::remove(frame(other.frames, 4)); // a frame in the middle
    goes_on_the_same();
}

TEST_CASE("a film of a given exposure has it in every frame, and each frame says what it is") {
    const recorded_flight::Folder folder;
    const content::Scenario scenario = bright_above();
    engine::FilmRequest request = request_for(folder / "film");
    request.exposure = render::Exposure{false, -1.5f, false};
    engine::make_film(scenario, nodding(scenario, request), request);
    for (const int number : {1, 3, 9}) {
        CHECK(stops(folder / "film", number) == -1.5);
    }
    const std::filesystem::path third = frame(folder / "film", 3);
    CHECK(tests::png_text(tests::contents(third), "scenario") == "nod");
    CHECK(tests::png_text(tests::contents(third), "method") == "ray");
    CHECK(tests::png_text(tests::contents(third), "mode") == "full");
    CHECK(tests::png_text(tests::contents(third), "samples_per_pixel") == "1");
    CHECK(tests::png_text(tests::contents(third), "projection") == "perspective");
    CHECK(tests::png_text(tests::contents(third), "beta") == "0");
    CHECK(tests::png_text(tests::contents(third), "look").find(" 1 ") != std::string::npos);
    CHECK(tests::png_text(tests::contents(third), "curve") == "filmic");
}

#include "engine/film/path_camera.h"

#include "../recorded_flight.h"
#include "engine/film/path_reel.h"
#include "sim/bad_input.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double metres = 20.0; // in a light second

content::CameraPath path_of(const std::string& text) {
    const recorded_flight::Folder folder;
    std::ofstream(folder / "path.toml") << text;
    return content::read_camera_path(folder / "path.toml", recorded_flight::scenario());
}

engine::PathCamera camera_of(const std::string& text) {
    return {path_of(text), metres};
}

/// Two keyframes ten seconds and `distance` light seconds apart.
std::string straight(const std::string& ends, double distance) {
    return "ends = \"" + ends + "\"\n[[keyframe]]\ntime = 0\nposition = [0, 0, 0]\n[[keyframe]]\ntime = 10\n" +
           "position = [" + std::to_string(metres * distance) + ", 0, 0]\n";
}

} // namespace

TEST_CASE("an eye on a straight path between two keyframes moves uniformly, and its clock is slow by gamma") {
    const engine::PathCamera camera = camera_of(straight("free", 8.0));
    for (const double time : {0.0, 2.5, 7.0, 10.0}) {
        const engine::PathCamera::Pose pose = camera.at(time);
        CHECK_THAT(pose.position.x, WithinAbs(0.8 * metres * time, 1e-12)); // roundings of 160 m
        CHECK_THAT(pose.velocity.x, WithinAbs(0.8, 1e-15));
        CHECK_THAT(sim::rapidity(pose.world_from_head).value, WithinAbs(std::atanh(0.8), 1e-14));
        CHECK_THAT(camera.proper_time(time).value, WithinAbs(0.6 * time, 1e-13)); // sums of 64 parts
        CHECK_THAT(camera.world_time(sim::ProperTime(0.6 * time)), WithinAbs(time, 1e-12));
    }
}

TEST_CASE(
    "an eye that starts and stops at rest is fastest in the middle, by 3/2, and its clock runs as its speed says") {
    const engine::PathCamera camera = camera_of(straight("rest", 6.0));
    CHECK(camera.at(0.0).velocity == glm::dvec3(0.0));
    CHECK_THAT(camera.at(5.0).velocity.x, WithinAbs(0.9, 1e-15));
    // v = 3.6 s (1 - s): the clock by Simpson's rule on 2000 parts, whose error is below 1e-13 here.
    constexpr int parts = 2000;
    double sum = 0.0;
    for (int i = 0; i <= parts; ++i) {
        const double s = static_cast<double>(i) / parts;
        const double v = 3.6 * s * (1.0 - s);
        sum += (i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * std::sqrt(1.0 - v * v);
    }
    CHECK_THAT(camera.proper_time(10.0).value, WithinAbs(10.0 * sum / (3.0 * parts), 1e-11));
}

TEST_CASE("a path as fast as light is refused where it is, however short it is so") {
    CHECK_NOTHROW(camera_of(straight("free", 9.999)));
    CHECK_NOTHROW(camera_of(straight("rest", 6.666))); // 0.9999 c in the middle
    CHECK_THROWS_MATCHES(camera_of(straight("rest", 6.667)), sim::BadInput,
                         MessageMatches(ContainsSubstring("path.toml: keyframe 1.position = 1.0000") &&
                                        ContainsSubstring("c at time 5")));
    CHECK_THROWS_MATCHES(camera_of(straight("free", 10.0)), sim::BadInput,
                         MessageMatches(ContainsSubstring("keyframe 1.position = 1 c at time 0")));
}

TEST_CASE("observers of their own velocities stay below c and have them at the keyframes") {
    const engine::PathCamera camera =
        camera_of("[[keyframe]]\ntime = 0\nposition = [0, 0, 0]\nvelocity = [0, 0, -0.99]\n"
                  "[[keyframe]]\ntime = 1\nposition = [1, 0, 0]\nvelocity = [0.5, 0, 0]\n"
                  "[[keyframe]]\ntime = 2\nposition = [2, 0, 0]\nvelocity = [0, 0, 0.999]\n");
    CHECK_FALSE(camera.travels());
    CHECK_THAT(camera.at(0.0).velocity.z, WithinAbs(-0.99, 1e-14));
    CHECK_THAT(camera.at(1.0).velocity.x, WithinAbs(0.5, 1e-14));
    CHECK_THAT(camera.at(2.0).velocity.z, WithinAbs(0.999, 1e-14));
    for (int i = 0; i <= 200; ++i) {
        CHECK(glm::length(camera.at(0.01 * i).velocity) < 1.0);
    }
}

TEST_CASE("an eye that looks at a place has it in the middle of its picture, as fast as it may be") {
    const std::string text = straight("free", 9.5);
    const std::string place = "look_at = [30, 4, -20]\nfield_of_view = 60\n";
    const engine::PathCamera camera =
        camera_of(text.substr(0, text.rfind("[[keyframe]]")) + place + text.substr(text.rfind("[[keyframe]]")) + place);
    for (const double time : {0.0, 1.0, 1.6, 5.0, 10.0}) {
        const engine::PathCamera::Pose pose = camera.at(time);
        const glm::dvec3 seen =
            sim::see(pose.world_from_head, sim::Direction<sim::Head>{{0.0, 0.0, -1.0}}).world_direction;
        // Roundings of an aberration by e^xi = 6.2.
        CHECK(glm::length(seen - glm::normalize(glm::dvec3(30.0, 4.0, -20.0) - pose.position)) < 1e-13);
        CHECK_THAT(pose.horizontal_field_of_view, WithinAbs(std::numbers::pi / 3.0, 1e-14));
    }
}

TEST_CASE("a look turns smoothly, a roll tilts to the right, a mode holds from its keyframe") {
    const engine::PathCamera camera =
        camera_of("[[keyframe]]\ntime = 0\nposition = [0, 0, 0]\nlook = [0, 0, -2]\n"
                  "[[keyframe]]\ntime = 1\nposition = [0, 0, 0]\nlook = [1, 0, 0]\nmode = \"geometry\"\nroll = 90\n"
                  "[[keyframe]]\ntime = 2\nposition = [0, 0, 0]\nlook = [0, 0, 1]\nroll = 90\n");
    const auto axis = [&camera](double time, const glm::dvec3& in_head) {
        return sim::tetrad(camera.at(time).world_from_head)[1].space * in_head.x +
               sim::tetrad(camera.at(time).world_from_head)[2].space * in_head.y +
               sim::tetrad(camera.at(time).world_from_head)[3].space * in_head.z;
    };
    const glm::dvec3 ahead(0.0, 0.0, -1.0);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    CHECK(glm::length(axis(0.0, ahead) - glm::dvec3(0.0, 0.0, -1.0)) < 1e-15);
    CHECK(glm::length(axis(0.0, up) - up) < 1e-15);
    CHECK(glm::length(axis(1.0, ahead) - glm::dvec3(1.0, 0.0, 0.0)) < 1e-14);
    CHECK(glm::length(axis(1.0, up) - glm::dvec3(0.0, 0.0, 1.0)) < 1e-14); // the right of one who looks along +x
    CHECK_THAT(axis(0.5, ahead).y, WithinAbs(0.0, 1e-15));
    CHECK_FALSE(camera.at(0.99).mode);
    CHECK(camera.at(1.0).mode == render::Mode::geometry);
    CHECK(camera.at(2.0).mode == render::Mode::geometry);
}

TEST_CASE("a path that makes no sense is refused with its file, keyframe and value") {
    const std::string first = "[[keyframe]]\ntime = 0\nposition = [0, 0, 0]\n";
    const auto refused = [](const std::string& text, const std::string& message) {
        INFO(text);
        CHECK_THROWS_MATCHES(camera_of(text), sim::BadInput,
                             MessageMatches(ContainsSubstring("path.toml: " + message)));
    };
    refused("title = 1\n" + first, "title = 1: this key is not known");
    refused("= 3", "line 1");
    refused(first, "keyframe: a path is two or more tables");
    refused("keyframe = 3\n", "keyframe: a path is two or more tables");
    refused(first + first, "keyframe 2.time = 0: must be later");
    refused(first + "[[keyframe]]\ntime = 1\n", "keyframe 2.position: missing");
    refused(first + "[[keyframe]]\ntime = nan\nposition = [0, 0, 0]\n", "keyframe 2.time = nan: ");
    refused(first + "[[keyframe]]\ntime = 1\nposition = [0, 0]\n", "keyframe 2.position = [ 0, 0 ]: ");
    refused(first + "velocity = [0, 1, 0]\n" + first, "keyframe 1.velocity = [ 0, 1, 0 ]: must be slower than light");
    refused(first + "velocity = [0, 0.5, 0]\n[[keyframe]]\ntime = 1\nposition = [0, 0, 0]\n",
            "keyframe 2.velocity: all keyframes have velocity, or none has");
    refused(first + "look = [0, 0, 0]\n" + first, "keyframe 1.look = [ 0, 0, 0 ]: must not be zero");
    refused(first + "look = [0, 0, 1]\nlook_at = [1, 1, 1]\n" + first, "keyframe 1.look_at = [ 1, 1, 1 ]: give either");
    refused(first + "look = [0, 0, 1]\n[[keyframe]]\ntime = 1\nposition = [0, 0, 0]\nlook = [0, 0, -1]\n",
            "keyframe 2.look: turns by more than 120 degrees");
    refused(first + "field_of_view = 180\n" + first, "keyframe 1.field_of_view = 180: ");
    refused(first + "mode = \"sepia\"\n[[keyframe]]\ntime = 1\nposition = [0, 0, 0]\n",
            "keyframe 1.mode = sepia: must be geometry");
    CHECK_THROWS_AS(content::read_camera_path("/nowhere/path.toml", {}), sim::BadInput);
}

TEST_CASE("a path's film is even in the world's time, or in the eye's, and contradictions are refused") {
    content::Scenario scenario = recorded_flight::scenario();
    scenario.speed_of_light = metres;
    engine::FilmRequest request;
    request.frames_per_second = 4.0;
    CHECK(engine::path_reel(scenario, path_of(straight("free", 8.0)), request).frames == 40);
    request.speed = 2.0;
    CHECK(engine::path_reel(scenario, path_of(straight("free", 8.0)), request).frames == 20);
    request.clock = engine::FilmClock::ship;
    const engine::FilmReel reel = engine::path_reel(scenario, path_of(straight("free", 8.0)), request);
    CHECK(reel.frames == 12);
    const engine::FilmShot shot = reel.shot(3);
    CHECK_THAT(std::get<double>(shot.metadata.at("eye_clock_seconds")), WithinAbs(1.5, 1e-12));
    CHECK_THAT(shot.frame.eye.position.x, WithinAbs(0.8 * metres * 1.5 / 0.6, 1e-10)); // by bisection of the clock

    std::string own = straight("free", 8.0);
    own.insert(own.rfind("[[keyframe]]"), "velocity = [0, 0, 0]\n");
    own += "velocity = [0, 0, 0]\n";
    CHECK_THROWS_AS(engine::path_reel(scenario, path_of(own), request), sim::BadInput); // no common clock
    request.clock.reset();
    CHECK_NOTHROW(engine::path_reel(scenario, path_of(own), request));
    request.mode = render::Mode::geometry;
    CHECK_THROWS_AS(engine::path_reel(scenario, path_of(own + "mode = \"full\"\n"), request), sim::BadInput);
}

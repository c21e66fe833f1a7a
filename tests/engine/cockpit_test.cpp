#include "engine/cockpit/comfort.h"
#include "engine/cockpit/panel_pointer.h"
#include "engine/fly/idle_watch.h"
#include "engine/fly/picture_keys.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;

namespace shared {
using glm::mix;
using glm::smoothstep;
namespace {
#include "render/shaders/shared/comfort.glsl"
}
} // namespace shared

TEST_CASE("a hand points at the place of the instruments' picture that the screen shows there") {
    const content::generator::Cabin cabin = content::generator::make_cabin();
    for (const content::generator::PanelScreen& screen : cabin.screens) {
        for (const double x : {-0.95, -0.3, 0.0, 0.6, 0.99}) {
            for (const double y : {-0.9, 0.1, 0.8}) {
                const glm::dvec3 point = screen.centre + x * screen.right + y * screen.up;
                const glm::dvec2 wanted =
                    screen.low + glm::dvec2(0.5 + 0.5 * x, 0.5 - 0.5 * y) * (screen.high - screen.low);
                // From the eyes, from a hand before the chest (one at the side has screens in the way), from just
                // before the place; any length of the direction.
                for (const glm::dvec3& origin : {glm::dvec3(0.0), glm::dvec3(0.05, -0.2, -0.1), 0.9 * point}) {
                    const auto place = engine::panel_place(cabin.screens, {origin, 3.0 * (point - origin)});
                    REQUIRE(place.has_value());
                    CHECK_THAT(place->x, WithinAbs(wanted.x, 1e-12));
                    CHECK_THAT(place->y, WithinAbs(wanted.y, 1e-12));
                }
                CHECK_FALSE(engine::panel_place(cabin.screens, {glm::dvec3(0.0), -point}));         // away from it
                CHECK_FALSE(engine::panel_place(cabin.screens, {1.2 * point, -point}).has_value()); // from behind
            }
        }
        const glm::dvec3 beside = screen.centre + 1.02 * screen.up;
        CHECK_FALSE(engine::panel_place(cabin.screens, {glm::dvec3(0.0), beside}));
    }
    CHECK_FALSE(engine::panel_place(cabin.screens, {glm::dvec3(0.0), {0.0, 0.0, -1.0}}));
    // Of two screens one behind the other the nearer is meant.
    std::vector<content::generator::PanelScreen> two(2);
    two[0] = {{0.0, 0.0, -2.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0}, {0.5, 1.0}};
    two[1] = {{0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.5, 0.0}, {1.0, 1.0}};
    CHECK_THAT(engine::panel_place(two, {}).value().x, WithinAbs(0.75, 1e-12));
}

TEST_CASE("the vignette is a smooth step between its two circles, and nothing when it is open") {
    for (const float from_axis : {0.0f, 0.5f, 1.0f, 1.5f}) {
        CHECK(shared::vignette_light(from_axis, 0.0f) ==
              1.0f); // a picture of 90 degrees, corners at 1.15, is untouched
    }
    CHECK(shared::vignette_light(0.25f, 1.0f) == 1.0f);
    CHECK_THAT(static_cast<double>(shared::vignette_light(0.5f, 1.0f)), WithinAbs(0.5, 1e-6)); // half-way
    CHECK(shared::vignette_light(0.75f, 1.0f) == 0.0f);
    float last = 1.0f;
    for (int i = 0; i <= 100; ++i) {
        const float light = shared::vignette_light(0.9f, 0.01f * static_cast<float>(i));
        CHECK(light <= last);
        last = light;
    }
}

TEST_CASE("the view narrows with the turn's rate, and opens again") {
    engine::TurnVignette vignette;
    CHECK(vignette.advance(0.0, 1.0F, 1.0) == 0.0F);
    // Exponential with its time constant, whatever the frame rate.
    float narrowed = 0.0F;
    for (int i = 0; i < 10; ++i) {
        narrowed =
            vignette.advance(0.5 * engine::TurnVignette::full_rate, 0.8F, 0.1 * engine::TurnVignette::closing_seconds);
    }
    CHECK_THAT(static_cast<double>(narrowed), WithinAbs(0.8 * 0.5 * (1.0 - std::exp(-1.0)), 1e-6));
    narrowed = vignette.advance(-10.0, 0.8F, 100.0); // either way, and no more than all
    CHECK_THAT(static_cast<double>(narrowed), WithinAbs(0.8, 1e-6));
    narrowed = vignette.advance(0.0, 0.8F, engine::TurnVignette::opening_seconds);
    CHECK_THAT(static_cast<double>(narrowed), WithinAbs(0.8 * std::exp(-1.0), 1e-6));
    CHECK(vignette.advance(0.0, 0.8F, 100.0) == 0.0F);              // exactly: the pass is left out
    CHECK(engine::TurnVignette().advance(10.0, 0.0F, 1.0) == 0.0F); // switched off
}

TEST_CASE("a demonstration waits just as long as nobody touches anything") {
    engine::IdleWatch watch(5.0);
    watch.advance(4.0, false);
    CHECK_FALSE(watch.over());
    CHECK_THAT(watch.seconds_left(), WithinAbs(1.0, 1e-12));
    watch.advance(0.1, true);
    CHECK_THAT(watch.seconds_left(), WithinAbs(5.0, 1e-12));
    watch.advance(5.0, false);
    CHECK(watch.over());
    CHECK(watch.seconds_left() == 0.0);
    watch.begin();
    CHECK_FALSE(watch.over());

    input::DeviceState devices;
    CHECK_FALSE(engine::is_touched(devices, false));
    CHECK(engine::is_touched(devices, true));
    devices.keys.set(input::Key::w, true);
    CHECK(engine::is_touched(devices, false));
    devices.keys.release_all();
    devices.keys.end_sample();
    devices.mouse.wheel = 1.0;
    CHECK(engine::is_touched(devices, false));
    devices.mouse.wheel = 0.0;
    devices.gamepad = input::GamepadState{};
    devices.gamepad->axes.at(0) = 0.1F; // a stick that does not rest quite in the middle
    CHECK_FALSE(engine::is_touched(devices, false));
    devices.gamepad->axes.at(static_cast<std::size_t>(input::GamepadAxis::right_trigger)) = 0.0F;
    CHECK(engine::is_touched(devices, false));
    devices.gamepad = input::GamepadState{};
    devices.gamepad->buttons.at(3) = true;
    CHECK(engine::is_touched(devices, false));
}

TEST_CASE("a demonstration locks menus and files, and flies") {
    for (const input::Action locked : {input::Action::panel, input::Action::quit, input::Action::full_screen,
                                       input::Action::screenshot, input::Action::bookmark}) {
        CHECK(engine::is_locked_in_demo(locked));
    }
    for (const input::Action free : {input::Action::help, input::Action::reset, input::Action::mode_next,
                                     input::Action::autopilot, input::Action::cockpit, input::Action::recentre}) {
        CHECK_FALSE(engine::is_locked_in_demo(free));
    }
}

#include "input/bindings.h"
#include "input/demand_grid.h"
#include "input/device_pilot.h"
#include "input/press_detector.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

using input::Action;
using input::DevicePilot;
using input::DeviceState;
using input::GamepadAxis;
using input::GamepadButton;
using input::GamepadState;
using input::Key;

namespace {

sim::VehicleSettings limited_vehicle() {
    sim::VehicleSettings vehicle;
    vehicle.maximum_acceleration = {1.0, 2.0, 3.0};
    vehicle.maximum_turn_rate = {0.25, 0.5, 0.75};
    vehicle.boost_factor = 4.0;
    return vehicle;
}

DeviceState with_keys(const std::vector<Key>& keys) {
    DeviceState devices;
    for (const Key key : keys) {
        devices.keys.set(key, true);
    }
    return devices;
}

DeviceState with_gamepad(GamepadAxis axis, float value) {
    DeviceState devices;
    devices.gamepad = GamepadState{};
    devices.gamepad->axes.at(static_cast<std::size_t>(axis)) = value;
    return devices;
}

/// The demand after the ramps have settled: ten seconds of holding.
sim::ControlFrame settled(DevicePilot& pilot, const DeviceState& devices) {
    pilot.sample(devices, {}, 10.0);
    sim::ControlFrame frame;
    for (sim::Tick tick = 0; tick < 2400; ++tick) {
        frame = pilot.control(tick).value();
    }
    return frame;
}

/// Direction the head looks in, vehicle axes.
glm::dvec3 look(const DevicePilot& pilot) {
    return pilot.vehicle_from_head() * glm::dvec3(0.0, 0.0, -1.0);
}

} // namespace

TEST_CASE("each key demands its axis' limit with the vehicle's signs") {
    struct Expectation {
        Key key;
        glm::dvec3 acceleration;
        glm::dvec3 turn;
    };
    const std::vector<Expectation> expectations{
        {Key::w, {0, 0, -3}, {}},       {Key::s, {0, 0, 3}, {}},        {Key::d, {1, 0, 0}, {}},
        {Key::a, {-1, 0, 0}, {}},       {Key::r, {0, 2, 0}, {}},        {Key::f, {0, -2, 0}, {}},
        {Key::up, {}, {0.25, 0, 0}},    {Key::down, {}, {-0.25, 0, 0}}, {Key::left, {}, {0, 0.5, 0}},
        {Key::right, {}, {0, -0.5, 0}}, {Key::q, {}, {0, 0, 0.75}},     {Key::e, {}, {0, 0, -0.75}},
    };
    for (const Expectation& expected : expectations) {
        INFO(input::key_name(expected.key));
        DevicePilot pilot(limited_vehicle());
        const sim::ControlFrame frame = settled(pilot, with_keys({expected.key}));
        CHECK(frame.proper_acceleration == expected.acceleration);
        CHECK(frame.angular_velocity == expected.turn);
    }
}

TEST_CASE("opposite keys cancel; boost multiplies the limit and sets its bit; brake sets its bit") {
    DevicePilot pilot(limited_vehicle());
    CHECK(settled(pilot, with_keys({Key::w, Key::s})).proper_acceleration == glm::dvec3(0.0));
    const sim::ControlFrame boosted = settled(pilot, with_keys({Key::w, Key::left_shift}));
    CHECK(boosted.proper_acceleration == glm::dvec3(0.0, 0.0, -12.0));
    CHECK(boosted.buttons == sim::ControlFrame::boost);
    CHECK(settled(pilot, with_keys({Key::space})).buttons == sim::ControlFrame::brake);
}

TEST_CASE("thrust follows a key smoothly and ends at exactly zero") {
    DevicePilot pilot(limited_vehicle());
    pilot.sample(with_keys({Key::w}), {}, 0.0);
    double before = 0.0;
    for (sim::Tick tick = 0; tick < 48; ++tick) { // 0.2 s at 240 ticks a second: one time constant
        const double now = -pilot.control(tick).value().proper_acceleration.z;
        CHECK(now > before);
        CHECK(now - before < 0.1); // 3 / 48 of the limit at the steepest
        before = now;
    }
    CHECK(before ==
          Catch::Approx(3.0 * (1.0 - std::exp(-1.0))).epsilon(1e-4)); // the grid of demands: half of 4 / 16,384
    CHECK(settled(pilot, {}).proper_acceleration == glm::dvec3(0.0));
}

TEST_CASE("a hand's demand is a multiple of a small power of two, and at its limit the limit") {
    for (const double limit : {0.35, 1.0, 3.0, 8.0, 1e-9, 12345.678}) {
        const double step = std::exp2(std::floor(std::log2(limit)) + 1.0 - 14.0);
        for (const double share : {0.0, 1e-9, 1e-4, 0.1234567, -0.5, 0.75, -0.99999, 1.0, -1.0, 1.2}) {
            const double demand = input::on_grid(share * limit, limit);
            INFO(limit << " times " << share);
            if (std::abs(share) >= 1.0) {
                CHECK(demand == std::copysign(limit, share));
            } else {
                CHECK(std::abs(demand) <= limit);
                CHECK(std::abs(demand - share * limit) <= 0.5 * step);
                CHECK((std::abs(demand) == limit || std::fmod(demand, step) == 0.0));
                CHECK(step <= limit / 8192.0);
            }
        }
    }
}

TEST_CASE("a slower pace leaves the ramps' time for the pilot the same") {
    DevicePilot normal(limited_vehicle());
    DevicePilot slow(limited_vehicle());
    slow.set_seconds_per_tick(2.0 / 240.0);
    normal.sample(with_keys({Key::w}), {}, 0.0);
    slow.sample(with_keys({Key::w}), {}, 0.0);
    static_cast<void>(normal.control(0));
    const double two_ticks = normal.control(1).value().proper_acceleration.z;
    CHECK(slow.control(0).value().proper_acceleration.z == Catch::Approx(two_ticks).epsilon(1e-12));
}

TEST_CASE("a vehicle without limits still flies by keyboard") {
    DevicePilot pilot(sim::VehicleSettings{});
    CHECK(settled(pilot, with_keys({Key::w})).proper_acceleration == glm::dvec3(0.0, 0.0, -1.0));
}

TEST_CASE("dead zone and curve of a stick") {
    const input::StickResponse response{0.2, 2.0};
    CHECK(input::respond(0.0, response) == 0.0);
    CHECK(input::respond(0.2, response) == 0.0);
    CHECK(input::respond(0.6, response) == Catch::Approx(0.25));
    CHECK(input::respond(1.0, response) == 1.0);
    CHECK(input::respond(1.4, response) == 1.0); // corners of a square stick
    CHECK(input::respond(std::nan(""), response) == 0.0);
}

TEST_CASE("the stick's dead zone is round: a diagonal within it does nothing, beyond it both axes answer") {
    GamepadState gamepad;
    gamepad.axes = {0.1F, 0.1F, 0.0F, 0.0F, -1.0F, -1.0F};
    const auto right = input::pad_positive(GamepadAxis::left_x);
    CHECK(input::pressed(gamepad, right, {0.15, 1.0}) == 0.0);
    gamepad.axes = {0.6F, 0.8F, 0.0F, 0.0F, -1.0F, -1.0F};
    CHECK(input::pressed(gamepad, right, {0.15, 1.0}) == Catch::Approx(0.6).epsilon(1e-6)); // float sticks
    CHECK(input::pressed(gamepad, input::pad_negative(GamepadAxis::left_x), {0.15, 1.0}) == 0.0);
}

TEST_CASE("sticks and triggers fly the ship") {
    DevicePilot pilot(limited_vehicle());
    CHECK(settled(pilot, with_gamepad(GamepadAxis::right_trigger, 1.0F)).proper_acceleration.z == -3.0);
    CHECK(settled(pilot, with_gamepad(GamepadAxis::right_x, -1.0F)).proper_acceleration.x == -1.0);
    CHECK(settled(pilot, with_gamepad(GamepadAxis::left_y, 1.0F)).angular_velocity.x == 0.25); // pulled: nose up
    CHECK(settled(pilot, with_gamepad(GamepadAxis::left_x, 1.0F)).angular_velocity.y == -0.5);
}

TEST_CASE("a gamepad that goes away lets go") {
    DevicePilot pilot(limited_vehicle());
    static_cast<void>(settled(pilot, with_gamepad(GamepadAxis::right_trigger, 1.0F)));
    CHECK(settled(pilot, DeviceState{}).proper_acceleration == glm::dvec3(0.0));
}

TEST_CASE("view keys and mouse turn the head") {
    DevicePilot pilot(limited_vehicle());
    const auto close_to = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-12; };
    CHECK(close_to(look(pilot), {0, 0, -1}));
    pilot.sample({}, {Action::look_behind}, 100.0);
    CHECK(close_to(look(pilot), {0, 0, 1}));
    pilot.sample({}, {Action::look_left}, 100.0);
    CHECK(close_to(look(pilot), {-1, 0, 0}));
    pilot.sample({}, {Action::look_right}, 100.0);
    CHECK(close_to(look(pilot), {1, 0, 0}));
    pilot.sample({}, {Action::look_up}, 100.0);
    CHECK(close_to(look(pilot), {0, 1, 0}));
    pilot.sample({}, {Action::look_ahead}, 100.0);
    DeviceState drag;
    drag.mouse.look_x = 0.1;
    pilot.sample(drag, {}, 0.0);
    CHECK(look(pilot).x == Catch::Approx(std::sin(0.24))); // 2.4 radians per window height
    CHECK(pilot.control(0).value().vehicle_from_head == pilot.vehicle_from_head());
}

TEST_CASE("switches stay on, pointing is one of several, and the same key lets go") {
    using sim::ControlFrame;
    DevicePilot pilot(limited_vehicle());
    const auto press = [&pilot](Action action) {
        pilot.sample({}, {action}, 0.0);
        return pilot.control(0).value();
    };
    CHECK(press(Action::autopilot).has(ControlFrame::autopilot));
    CHECK(press(Action::cruise).buttons == (ControlFrame::autopilot | ControlFrame::cruise));
    pilot.switch_off(ControlFrame::autopilot | ControlFrame::cruise);
    CHECK(press(Action::point_prograde).pointing() == sim::Pointing::prograde);
    CHECK(press(Action::point_now).pointing() == sim::Pointing::target_now);
    CHECK(press(Action::dampers).has(ControlFrame::undamped));
    CHECK(press(Action::about_target).has(ControlFrame::about_target));
    CHECK(press(Action::brake_switch).has(ControlFrame::brake));
    const ControlFrame off = press(Action::point_now);
    CHECK(off.pointing() == sim::Pointing::free);
    CHECK(off.buttons == (ControlFrame::undamped | ControlFrame::about_target | ControlFrame::brake));
}

TEST_CASE("a step to the side moves the head by its velocity, never as fast as light") {
    for (const double metres_per_light_unit : {1.0, 20.0, 299792458.0}) {
        DevicePilot pilot(limited_vehicle());
        pilot.set_metres_per_light_unit(metres_per_light_unit);
        pilot.sample(with_keys({Key::apostrophe}), {}, 0.0);
        double place = 0.0;
        double fastest = 0.0;
        for (sim::Tick tick = 0; tick < 1000; ++tick) {
            const sim::ControlFrame frame = pilot.control(tick).value();
            place += frame.head_velocity.x / 240.0;
            fastest = std::max(fastest, frame.head_velocity.x);
            CHECK(frame.head_position.x == Catch::Approx(place).epsilon(1e-12)); // a sum of a thousand roundings
        }
        CHECK(place * metres_per_light_unit == Catch::Approx(0.5));
        CHECK(fastest <= 0.9);
        // The first tick goes 0.5 m (1 - e^(-1 / (240 x 0.25))).
        const double first = 240.0 * 0.5 * (1.0 - std::exp(-1.0 / 60.0)) / metres_per_light_unit;
        CHECK(fastest == Catch::Approx(std::min(first, 0.9)));
    }
}

TEST_CASE("a tap between two samples is seen once, a held key is pressed once") {
    input::PressDetector detector;
    DeviceState devices;
    devices.keys.set(Key::p, true);
    devices.keys.set(Key::p, false);
    CHECK(detector.presses(devices) == std::vector<Action>{Action::pause});
    devices.keys.end_sample();
    CHECK(detector.presses(devices).empty());
    devices.keys.set(Key::p, true);
    CHECK(detector.presses(devices) == std::vector<Action>{Action::pause});
    devices.keys.end_sample();
    CHECK(detector.presses(devices).empty());
}

TEST_CASE("the table binds every action, no control twice, and names every control") {
    std::set<Action> actions;
    std::set<Key> keys;
    std::set<std::string_view> pads;
    for (const input::Binding& binding : input::bindings()) {
        INFO(binding.group << ": " << binding.what);
        CHECK(actions.insert(binding.action).second);
        for (const Key key : {binding.key, binding.second_key}) {
            CHECK((key == Key::none || keys.insert(key).second));
        }
        const std::string_view control = input::control_name(binding.gamepad);
        CHECK((control.empty() || pads.insert(control).second));
        const std::string desk = input::desk_controls(binding);
        CHECK_FALSE(desk.empty());
        CHECK(desk.find('?') == std::string::npos);
    }
    CHECK(actions.size() == static_cast<std::size_t>(Action::count));
}

TEST_CASE("a step's key turns by just that angle in one tick, paused or not") {
    DevicePilot pilot(limited_vehicle());
    pilot.set_snap_turn(0.5, false);
    pilot.sample({}, {Action::snap_left, Action::snap_left, Action::snap_right, Action::snap_left}, 0.1);
    for (int i = 0; i < 2; ++i) { // three to the left less one to the right
        const sim::ControlFrame frame = pilot.control(i).value();
        CHECK(frame.has(sim::ControlFrame::snap_turn));
        CHECK(frame.angular_velocity == glm::dvec3(0.0, 0.5 * 240.0, 0.0));
    }
    CHECK_FALSE(pilot.control(2)->has(sim::ControlFrame::snap_turn));
    pilot.sample({}, {Action::snap_right}, 0.1);
    CHECK(pilot.control(3)->angular_velocity.y == -0.5 * 240.0);
}

TEST_CASE("where turning is by steps a held stick turns by one until it is let go") {
    DevicePilot pilot(limited_vehicle());
    pilot.set_snap_turn(0.5, true);
    const auto snaps = [&](float deflection) {
        pilot.sample(with_gamepad(GamepadAxis::left_x, deflection), {}, 0.1);
        double turned = 0.0;
        for (sim::Tick tick = 0; tick < 10; ++tick) {
            const sim::ControlFrame frame = pilot.control(tick).value();
            turned += frame.angular_velocity.y / 240.0;
        }
        return turned;
    };
    CHECK(snaps(0.3F) == 0.0); // not far enough, and no smooth turn either
    CHECK(snaps(1.0F) == -0.5);
    CHECK(snaps(1.0F) == 0.0);
    CHECK(snaps(0.0F) == 0.0);
    CHECK(snaps(-1.0F) == 0.5);
    CHECK(settled(pilot, with_keys({Key::up})).angular_velocity.x > 0.0); // pitch and roll as ever
}

TEST_CASE("hands and head are the seat's, however it is turned in the ship") {
    DevicePilot pilot(limited_vehicle());
    const glm::dquat roll = glm::angleAxis(std::acos(-1.0) / 2.0, glm::dvec3(0.0, 0.0, 1.0)); // x goes to y
    pilot.set_vehicle_from_seat(roll);
    const sim::ControlFrame right = settled(pilot, with_keys({Key::d}));
    CHECK(glm::distance(right.proper_acceleration, glm::dvec3(0.0, 1.0, 0.0)) < 1e-12);
    const sim::ControlFrame nose_up = settled(pilot, with_keys({Key::up}));
    CHECK(glm::distance(nose_up.angular_velocity, glm::dvec3(0.0, 0.25, 0.0)) < 1e-12);
    CHECK(glm::distance(nose_up.vehicle_from_head * glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0)) < 1e-12);
    const sim::ControlFrame step = settled(pilot, with_keys({Key::apostrophe}));
    CHECK(step.head_position.y > 0.0);
    CHECK(std::abs(step.head_position.x) < 1e-15);
}

TEST_CASE("recentred, the head is ahead at once and goes back to the middle") {
    DevicePilot pilot(limited_vehicle());
    DeviceState looking = with_keys({Key::apostrophe});
    looking.mouse.look_x = 0.2;
    pilot.sample(looking, {}, 0.1);
    pilot.control(0);
    REQUIRE(std::abs(pilot.vehicle_from_head().y) > 0.1);
    pilot.recentre();
    CHECK(pilot.vehicle_from_head() == glm::dquat(1.0, 0.0, 0.0, 0.0));
    CHECK(glm::length(settled(pilot, {}).head_position) == 0.0);
}

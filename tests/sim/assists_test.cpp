#include "sim/approach.h"
#include "sim/assists.h"
#include "sim/flight_log.h"
#include "sim/propellant.h"
#include "sim/readings.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/matrix.hpp>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using sim::ControlFrame;
using sim::Pointing;

namespace {

sim::VehicleSettings agile() {
    sim::VehicleSettings settings;
    settings.maximum_acceleration = glm::dvec3(1.0);
    settings.maximum_turn_rate = glm::dvec3(2.0);
    settings.maximum_turn_acceleration = glm::dvec3(4.0);
    return settings;
}

ControlFrame switched(std::uint32_t buttons, Pointing pointing = Pointing::free) {
    ControlFrame control;
    control.buttons = buttons | static_cast<std::uint32_t>(pointing) * ControlFrame::first_pointing;
    return control;
}

sim::VehicleState flown(sim::VehicleState state, const sim::VehicleSettings& settings, const ControlFrame& control,
                        int ticks) {
    for (int i = 0; i < ticks; ++i) {
        state = sim::advance(state, settings, control);
    }
    return state;
}

sim::VehicleState moving(double rapidity, const glm::dvec3& along) {
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(rapidity), along);
    return state;
}

/// What the pilot sees looking ahead.
sim::Lorentz<sim::World, sim::Head> eye(const sim::VehicleState& state) {
    return {state.world_from_vehicle.spin};
}

const glm::dvec3 nose(0.0, 0.0, -1.0);

} // namespace

TEST_CASE("turn rates change no faster than their limit; undamped they stay, damped they die out") {
    ControlFrame turning;
    turning.angular_velocity = {0.0, 1.0, 0.0};
    sim::VehicleState state = flown({}, agile(), turning, 30);
    CHECK_THAT(state.angular_velocity.y, WithinRel(4.0 * 30.0 / 240.0, 1e-14)); // 30 ticks of 4 rad per unit squared
    state = flown(state, agile(), turning, 60);
    CHECK(state.angular_velocity.y == 1.0);
    CHECK(flown(state, agile(), switched(ControlFrame::undamped), 1000).angular_velocity.y == 1.0);
    const sim::VehicleState damped = flown(state, agile(), switched(0), 61);
    CHECK(damped.angular_velocity.y == 0.0);
    turning.buttons = switched(0, Pointing::hold_heading).buttons;
    CHECK(flown(damped, agile(), turning, 100).angular_velocity == glm::dvec3(0.0));
}

TEST_CASE("a held heading is a gyroscope's: in a turn it shows the Thomas-Wigner angle") {
    // Two burns at right angles, hands off and on the turn keys: the frame is the product of the two boosts.
    ControlFrame control = switched(0, Pointing::hold_heading);
    control.angular_velocity = {0.3, -0.2, 0.1};
    control.proper_acceleration = {1.0, 0.0, 0.0};
    sim::VehicleState state = flown({}, agile(), control, 240);
    control.proper_acceleration = {0.0, 1.0, 0.0};
    state = flown(state, agile(), control, 240);
    const glm::dmat3 rotation = sim::split(eye(state)).boosted_from_head;
    const double expected = 2.0 * std::atan(std::pow(std::tanh(0.5), 2.0));
    CHECK_THAT(std::abs(std::atan2(rotation[0].y, rotation[0].x)), WithinAbs(expected, 1e-11)); // RK4's error
}

TEST_CASE("pointing brings the nose to where it says, and keeps it there under thrust") {
    sim_tests::RandomFrames random;
    for (int i = 0; i < 10; ++i) {
        sim::VehicleState start;
        start.world_from_vehicle = random.frame<sim::World, sim::Vehicle>(1.5);
        start.guidance.has_target = 1;
        start.guidance.target = {100.0 * random.unit(), 0.6 * random.unit()};
        const auto settled = [&](Pointing pointing) { return flown(start, agile(), switched(0, pointing), 1200); };
        // Half a turn takes under two units; 1200 ticks are five. A curve that is followed by ticks ends within a few
        // roundings of the direction.
        const glm::dvec3 ahead = sim::readings(settled(Pointing::prograde)).motion_in_vehicle;
        CHECK(glm::distance(ahead, nose) < 1e-9);
        const glm::dvec3 behind = sim::readings(settled(Pointing::retrograde)).motion_in_vehicle;
        CHECK(glm::distance(behind, -nose) < 1e-9);
        // 100 away, the target drifts across this sky by at most e^1.5 (tanh 1.5 + 0.6) / 100 in a unit of ship time:
        // 3e-4 in a tick.
        const sim::VehicleState seen = settled(Pointing::target_seen);
        CHECK(glm::distance(sim::sighting(sim::far_event(seen), eye(seen), start.guidance.target).seen, nose) < 3e-4);
        const sim::VehicleState now = settled(Pointing::target_now);
        CHECK(glm::distance(sim::sighting(sim::far_event(now), eye(now), start.guidance.target).now, nose) < 3e-4);
    }
}

TEST_CASE("a target at rest is seen aberrated, and is now where its contracted place is") {
    // Motion along -z with beta 0.6; the target abeam in the world.
    sim::VehicleState state = moving(std::atanh(0.6), {0.0, 0.0, -1.0});
    const sim::Sighting target = sim::sighting(sim::far_event(state), eye(state), {{8.0, 0.0, -6.0}, {}});
    // cos theta' = (cos theta + beta) / (1 + beta cos theta) = 1.2 / 1.36; D = 1 / (gamma (1 + beta cos theta)).
    CHECK_THAT(-target.seen.z, WithinRel(1.2 / 1.36, 1e-15));
    CHECK_THAT(target.wavelength_ratio, WithinRel(0.8 / 1.36, 1e-15));
    // The place is 6 / gamma ahead and 8 aside.
    CHECK_THAT(target.now.x / -target.now.z, WithinRel(8.0 / 4.8, 1e-15));
    CHECK(target.distance == 10.0);
    CHECK(target.clock_seen == -10.0);
    CHECK(target.clock_now == 0.0);
}

TEST_CASE("the home clock is seen slow on the way out, fast on the way home, and right at home") {
    // The twin at 0.8 c: a clock at home is seen to run 1/3 as fast, then three times.
    const sim::InertialObject home;
    const double xi = std::atanh(0.8);
    sim::VehicleState ship = moving(xi, {1.0, 0.0, 0.0});
    double last_seen = 0.0;
    for (int i = 0; i < 720; ++i) { // three years out
        ship = sim::advance(ship, {}, {});
        const sim::Sighting clock = sim::sighting(sim::far_event(ship), eye(ship), home);
        CHECK_THAT(clock.wavelength_ratio, WithinRel(3.0, 1e-13));
        CHECK_THAT(clock.clock_seen - last_seen, WithinAbs(1.0 / 720.0, 1e-14));
        last_seen = clock.clock_seen;
    }
    CHECK_THAT(last_seen, WithinAbs(1.0, 1e-12));
    CHECK_THAT(ship.event.t, WithinAbs(5.0, 1e-12));
    ship.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(xi), {-1.0, 0.0, 0.0});
    for (int i = 0; i < 720; ++i) {
        ship = sim::advance(ship, {}, {});
        const sim::Sighting clock = sim::sighting(sim::far_event(ship), eye(ship), home);
        CHECK_THAT(clock.clock_seen - last_seen, WithinAbs(3.0 / 240.0, 1e-14));
        last_seen = clock.clock_seen;
    }
    CHECK_THAT(last_seen, WithinAbs(10.0, 1e-12));
    CHECK(ship.ship_clock.value == 6.0);
}

TEST_CASE("a moving clock is seen with the delay and the shift of the truth by another way") {
    sim_tests::RandomFrames random;
    for (int i = 0; i < 50; ++i) {
        sim::VehicleState ship;
        ship.world_from_vehicle = random.frame<sim::World, sim::Vehicle>(2.0);
        ship.event = {random.uniform(-3.0, 3.0), 3.0 * random.unit()};
        const sim::InertialObject object{5.0 * random.unit(), 0.9 * random.unit()};
        const sim::Sighting here = sim::sighting(sim::far_event(ship), eye(ship), object);
        const sim::Emission light = sim::retarded_emission(object, ship.event);
        const sim::SeenFrom seen = sim::where_seen(sim::split(eye(ship)), light.from);
        // Products of a few boosts of rapidity 2 and 1.5: gamma^2 of 100 times roundings.
        CHECK(glm::distance(here.seen, seen.head_direction) < 1e-13);
        CHECK_THAT(here.wavelength_ratio, WithinRel(seen.wavelength_ratio * light.wavelength_ratio, 1e-13));
        const double inverse_gamma = std::sqrt(1.0 - 0.81);
        CHECK_THAT(here.clock_seen, WithinAbs(light.event.t * inverse_gamma, 1e-12));
        CHECK_THAT(here.clock_now, WithinAbs(ship.event.t * inverse_gamma, 1e-14));
    }
}

TEST_CASE("cruise holds its rapidity against the world or the target, from rest, below and above") {
    for (const double cruise : {0.0, 0.7, 2.0}) {
        sim::VehicleState state = moving(1.2, {0.0, 0.6, 0.8});
        state.guidance.cruise = sim::Rapidity(cruise);
        CHECK_THAT(sim::readings(flown(state, agile(), switched(ControlFrame::cruise), 500)).rapidity.value,
                   WithinAbs(cruise, 1e-14));
        state.guidance.has_target = 1;
        state.guidance.target.velocity = {0.5, 0.0, 0.0};
        const auto about = switched(ControlFrame::cruise | ControlFrame::about_target);
        const sim::VehicleState end = flown(state, agile(), about, 900);
        CHECK_THAT(sim::approach(end, state.guidance.target).motion.xi.value, WithinAbs(cruise, 1e-14));
    }
    sim::VehicleState still;
    still.guidance.cruise = sim::Rapidity(0.5);
    CHECK(sim::readings(flown(still, agile(), switched(ControlFrame::cruise), 240)).motion_in_vehicle.z == -1.0);
}

TEST_CASE("the brake stops the ship against what it is told to") {
    sim::VehicleState state = moving(1.0, {0.0, 0.0, -1.0});
    state.guidance.has_target = 1;
    state.guidance.target.velocity = {0.0, 0.8, 0.0};
    const sim::VehicleState end =
        flown(state, agile(), switched(ControlFrame::brake | ControlFrame::about_target), 900);
    const glm::dvec3 u = sim::four_velocity(end.world_from_vehicle).space;
    CHECK(glm::distance(u, glm::dvec3(0.0, 0.8, 0.0) / 0.6) < 1e-14);
}

TEST_CASE("a tank that runs dry ends the thrust by the rocket equation") {
    sim::VehicleSettings settings = agile();
    settings.propellant = 1.0;
    settings.exhaust_speed = 0.5;
    ControlFrame control;
    control.proper_acceleration = {0.0, 0.0, -0.7};
    sim::FlightLog log;
    sim::VehicleState state;
    bool told = false;
    for (int i = 0; i < 240; ++i) {
        const sim::VehicleState before = state;
        state = sim::advance(state, settings, control);
        const auto event = log.watch(before, state, settings);
        told = told || (event && event->kind == sim::FlightEventKind::propellant_spent);
    }
    // From rest to empty: xi = v ln(mass ratio), at any speed.
    CHECK_THAT(sim::readings(state).rapidity.value, WithinRel(0.5 * std::log(2.0), 1e-12)); // RK4's error
    CHECK(state.felt_acceleration == glm::dvec3(0.0));
    CHECK(sim::propellant_left(settings, state) == 0.0);
    CHECK(told);
}

TEST_CASE("a head that moves in the vehicle sees the sky of its own velocity") {
    // Two boosts along one line: rapidities add, in aberration and in D.
    const sim::VehicleState ship = moving(0.8, {0.0, 0.0, -1.0});
    const auto step =
        sim::world_from_head(ship.world_from_vehicle, glm::dquat(1.0, 0.0, 0.0, 0.0), {0.0, 0.0, -std::tanh(0.5)});
    CHECK_THAT(sim::rapidity(step).value, WithinRel(1.3, 1e-14));
    CHECK_THAT(sim::see(step, {nose}).wavelength_ratio, WithinRel(std::exp(-1.3), 1e-14));
    // A sideways step at rest: light from abeam is seen at cos theta' = beta towards the step.
    const auto aside = sim::world_from_head({}, glm::dquat(1.0, 0.0, 0.0, 0.0), {0.3, 0.0, 0.0});
    CHECK_THAT(sim::where_seen(sim::split(aside), {nose}).head_direction.x, WithinRel(0.3, 1e-14));
}

TEST_CASE("the log tells of a flight by hand") {
    ControlFrame ahead;
    ahead.proper_acceleration = {0.0, 0.0, -1.0};
    ControlFrame about;
    about.angular_velocity = {0.0, 2.0, 0.0};
    sim::FlightLog log;
    sim::VehicleState state;
    std::vector<sim::FlightEventKind> events;
    for (int i = 0; i < 1400; ++i) {
        const sim::VehicleState before = state;
        state = sim::advance(state, agile(), i < 240 ? ahead : i < 600 ? about : switched(ControlFrame::brake));
        if (const auto event = log.watch(before, state, agile())) {
            events.push_back(event->kind);
            CHECK(event->tick == state.tick);
            CHECK(event->world_clock.value == state.event.t);
        }
    }
    CHECK(events ==
          std::vector{sim::FlightEventKind::departure, sim::FlightEventKind::flip, sim::FlightEventKind::arrival});
}

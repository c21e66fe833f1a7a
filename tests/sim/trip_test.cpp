#include "sim/approach.h"
#include "sim/autopilot.h"
#include "sim/flight_log.h"
#include "sim/propellant.h"
#include "sim/readings.h"
#include "sim/trip.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <algorithm>
#include <vector>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using sim::AutopilotPhase;

namespace {

/// 1 g in c per year; ticks of four hours.
sim::VehicleSettings starship() {
    sim::VehicleSettings settings;
    settings.maximum_acceleration = glm::dvec3(1.0323);
    settings.maximum_turn_rate = glm::dvec3(8.0);
    settings.tick_rate = 2000.0;
    return settings;
}

sim::VehicleState bound_for(const glm::dvec3& place, const glm::dvec3& velocity = glm::dvec3(0.0)) {
    sim::VehicleState state;
    state.guidance.has_target = 1;
    state.guidance.target = {place, velocity};
    return state;
}

struct Flown {
    sim::VehicleState end;
    double peak_gamma = 1.0;
    double most_thrust = 0.0; ///< largest of |a_i| / limit_i
    double most_turn = 0.0;
    double most_turn_change = 0.0; ///< per clock unit
    std::vector<sim::FlightEventKind> events;
};

Flown fly(const sim::VehicleState& start, const sim::VehicleSettings& settings, double most_clock_units) {
    sim::ControlFrame control;
    control.buttons = sim::ControlFrame::autopilot;
    sim::FlightLog log;
    Flown flown{start, 1.0, 0.0, 0.0, 0.0, {}};
    const double ticks = most_clock_units * settings.tick_rate + 100.0;
    for (double i = 0.0; i < ticks; i += 1.0) {
        const sim::VehicleState before = flown.end;
        flown.end = sim::advance(before, settings, control);
        flown.peak_gamma = std::max(flown.peak_gamma, sim::four_velocity(flown.end.world_from_vehicle).t);
        for (int axis = 0; axis < 3; ++axis) {
            const double a = std::abs(flown.end.felt_acceleration[axis]) / settings.maximum_acceleration[axis];
            const double w = std::abs(flown.end.angular_velocity[axis]) / settings.maximum_turn_rate[axis];
            flown.most_thrust = std::max(flown.most_thrust, a);
            flown.most_turn = std::max(flown.most_turn, w);
            const double change = std::abs(flown.end.angular_velocity[axis] - before.angular_velocity[axis]);
            flown.most_turn_change = std::max(flown.most_turn_change, change * settings.tick_rate);
        }
        if (const auto event = log.watch(before, flown.end, settings)) {
            flown.events.push_back(event->kind);
        }
        if (!sim::is_flying(flown.end.guidance.phase)) {
            break;
        }
    }
    return flown;
}

} // namespace

TEST_CASE("a trip from rest is the textbook's: cosh(a tau / 2) = 1 + a d / 2") {
    const double a = 1.0323;
    for (const double distance : {4.37, 1000.0, 1e6}) {
        const sim::TripForecast plan = sim::plan_trip(bound_for({0.0, 0.6 * distance, -0.8 * distance}), starship());
        const double half = std::acosh(1.0 + 0.5 * a * distance) / a;
        // Whole ticks, and 1e-4 of the braking thrust kept back for corrections.
        CHECK_THAT(plan.ship_time.value, WithinAbs(2.0 * half, 3.0 / 2000.0 + 1e-4 * half));
        CHECK_THAT(plan.world_time.value, WithinRel(2.0 * std::sinh(a * half) / a, 1e-3));
        CHECK_THAT(plan.peak_gamma, WithinRel(1.0 + 0.5 * a * distance, 2e-3));
        CHECK_THAT(plan.rapidity_spent.value, WithinAbs(2.0 * a * half, 2e-3));
        // A photon rocket's mass ratio is e^rapidity (Ackeret).
        CHECK_THAT(plan.mass_ratio, WithinRel(std::exp(plan.rapidity_spent.value), 1e-14));
    }
}

TEST_CASE("the flight keeps its forecast from 1e-3 to a million light-years, and ends at rest on the spot") {
    for (const double distance : {1e-3, 4.37, 1000.0, 1e6}) {
        const glm::dvec3 place(0.6 * distance, 0.0, -0.8 * distance);
        const sim::VehicleState start = bound_for(place);
        const sim::TripForecast plan = sim::plan_trip(start, starship());
        const Flown flown = fly(start, starship(), 1.01 * plan.ship_time.value);
        REQUIRE(flown.end.guidance.phase == AutopilotPhase::arrived);
        CHECK(static_cast<double>(flown.end.tick) == std::round(plan.ship_time.value * 2000.0));
        // RK4 leaves (a / 2000)^4; the last digits of gamma's share follow Lambda's.
        CHECK_THAT(flown.end.event.t, WithinRel(plan.world_time.value, 1e-11));
        CHECK_THAT(flown.peak_gamma, WithinRel(plan.peak_gamma, 1e-10));
        // Turning to the burns and small corrections.
        CHECK_THAT(flown.end.rapidity_spent.value, WithinRel(plan.rapidity_spent.value, 1e-5));
        const sim::Approach end = sim::approach(flown.end, start.guidance.target);
        CHECK(glm::length(end.way) < 3e-15); // light-years: thirty metres
        CHECK(end.motion.xi.value < 1e-12);  // 0.3 mm/s
        CHECK(flown.events ==
              std::vector{sim::FlightEventKind::departure, sim::FlightEventKind::flip, sim::FlightEventKind::arrival});
    }
}

TEST_CASE("from any motion to any inertial target, within every limit, as foretold") {
    sim_tests::RandomFrames random;
    for (int i = 0; i < 120; ++i) {
        sim::VehicleSettings settings;
        settings.maximum_acceleration = glm::dvec3(random.uniform(0.3, 2.0));
        settings.maximum_turn_rate = glm::dvec3(random.uniform(1.0, 4.0));
        const bool weak_sides = i % 3 == 1;
        if (i % 3 != 0) {
            settings.maximum_turn_acceleration = glm::dvec3(random.uniform(2.0, 6.0));
        }
        if (weak_sides) { // must turn to thrust
            settings.maximum_acceleration *= glm::dvec3(0.2, 0.3, 1.0);
        }
        sim::VehicleState start =
            bound_for(random.uniform(0.5, 20.0) * random.unit(), random.uniform(0.0, 0.9) * random.unit());
        start.world_from_vehicle = random.frame<sim::World, sim::Vehicle>(random.uniform(0.0, 3.0));
        start.event = {random.uniform(-5.0, 5.0), random.uniform(0.0, 5.0) * random.unit()};
        const sim::TripForecast plan = sim::plan_trip(start, settings);
        REQUIRE(plan.problem == sim::TripProblem::none);
        const Flown flown = fly(start, settings, 1.2 * plan.ship_time.value);
        INFO("flight " << i << ", ship time " << plan.ship_time.value);
        REQUIRE(flown.end.guidance.phase == AutopilotPhase::arrived);
        // A ship that is still turning at the end needs some ticks more; it happened in one flight of a hundred.
        const double ticks_more = static_cast<double>(flown.end.tick) - plan.ship_time.value * settings.tick_rate;
        CHECK(std::abs(ticks_more) < 8.0);
        CHECK_THAT(flown.end.event.t - start.event.t, WithinRel(plan.world_time.value, 1e-2));
        if (std::abs(ticks_more) < 0.5) {
            CHECK_THAT(flown.end.event.t - start.event.t, WithinRel(plan.world_time.value, 1e-6));
        }
        const sim::Approach end = sim::approach(flown.end, start.guidance.target);
        CHECK(glm::length(end.way) < 1e-11); // a tick's thrust moves the ship by 1e-5
        CHECK(end.motion.xi.value < 1e-9);
        CHECK(flown.most_thrust <= 1.0);
        CHECK(flown.most_turn <= 1.0);
        CHECK(flown.most_turn_change <=
              settings.maximum_turn_acceleration.x * (1.0 + 1e-12)); // a difference's rounding
    }
}

TEST_CASE("with little propellant the ship coasts, and what is burnt stays within it") {
    sim::VehicleSettings settings = starship();
    settings.exhaust_speed = 0.8;
    settings.propellant = 5.0;
    const sim::VehicleState start = bound_for({0.0, 0.0, -20.0});
    const sim::TripForecast plan = sim::plan_trip(start, settings);
    REQUIRE(plan.problem == sim::TripProblem::none);
    CHECK(plan.trip.schedule.coast > 0.0);
    CHECK_THAT(plan.rapidity_spent.value, WithinRel(0.8 * std::log(6.0), 2e-3)); // a thousandth is kept in reserve
    const Flown flown = fly(start, settings, 1.01 * plan.ship_time.value);
    CHECK(flown.end.guidance.phase == AutopilotPhase::arrived);
    CHECK_THAT(flown.end.event.t, WithinRel(plan.world_time.value, 1e-6));
    CHECK(sim::propellant_left(settings, flown.end) > 0.0);
    // Mass before over mass after, both ways.
    CHECK_THAT(6.0 / (1.0 + sim::propellant_left(settings, flown.end)),
               WithinRel(sim::mass_ratio(settings, flown.end.rapidity_spent), 1e-14));
}

TEST_CASE("what cannot be flown is said before, and the autopilot hands back") {
    sim::VehicleState state; // no target
    CHECK(sim::plan_trip(state, starship()).problem == sim::TripProblem::no_target);
    CHECK(fly(state, starship(), 1.0).end.guidance.phase == AutopilotPhase::no_target);

    sim::VehicleSettings empty = starship();
    empty.propellant = 0.1; // good for rapidity 0.095; it takes 1 to stop
    state = bound_for({0.0, 0.0, -5.0});
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(1.0), {0.0, 1.0, 0.0});
    CHECK(sim::plan_trip(state, empty).problem == sim::TripProblem::too_little_propellant);
    CHECK(fly(state, empty, 1.0).end.guidance.phase == AutopilotPhase::no_propellant);

    sim::VehicleSettings feeble = starship();
    feeble.maximum_acceleration = glm::dvec3(1e-13); // 28 million years
    CHECK(sim::plan_trip(bound_for({0.0, 0.0, -5.0}), feeble).problem == sim::TripProblem::too_slow);
}

TEST_CASE("hands that take the ship off its course do not keep the autopilot from arriving") {
    const sim::VehicleState start = bound_for({1.0, 0.0, -2.0});
    sim::VehicleState state = start;
    sim::ControlFrame autopilot;
    autopilot.buttons = sim::ControlFrame::autopilot;
    sim::ControlFrame hands;
    hands.proper_acceleration = {1.0, 1.0, 0.0};
    for (int i = 0; i < 12000 && state.guidance.phase != AutopilotPhase::arrived; ++i) {
        state = sim::advance(state, starship(), i > 1500 && i < 2500 ? hands : autopilot);
    }
    CHECK(state.guidance.phase == AutopilotPhase::arrived);
    CHECK(glm::length(sim::approach(state, start.guidance.target).way) < 3e-15);
}

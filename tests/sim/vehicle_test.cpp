#include "sim/flight_script.h"
#include "sim/readings.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <numbers>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double rate = 240.0;

sim::VehicleState flown(const sim::FlightScript& script, double steps_per_unit = rate) {
    sim::VehicleState state;
    for (const sim::FlightSegment& segment : script) {
        state = sim::fly_segment(state, segment, steps_per_unit);
    }
    return state;
}

sim::FlightSegment thrust(double duration, const glm::dvec3& a) {
    return {sim::ProperTime(duration), a, {}};
}

sim::VehicleSettings limited(double acceleration) {
    sim::VehicleSettings settings;
    settings.maximum_acceleration = glm::dvec3(acceleration);
    return settings;
}

} // namespace

TEST_CASE("constant thrust gives t = sinh(a tau)/a and x = (cosh(a tau) - 1)/a") {
    for (const double a : {0.3, 1.0, 2.0}) {
        const sim::VehicleState state = flown({thrust(5.0, {0.0, 0.0, -a})});
        // RK4 at 240 Hz: (a/240)^4/120 per unit of a tau, below 4e-10 for a = 2.
        CHECK_THAT(state.event.t, WithinRel(std::sinh(5.0 * a) / a, 1e-10));
        CHECK_THAT(-state.event.space.z, WithinRel((std::cosh(5.0 * a) - 1.0) / a, 1e-10));
        CHECK_THAT(sim::rapidity(state.world_from_vehicle).value, WithinRel(5.0 * a, 1e-11));
    }
}

TEST_CASE("the twin comes home younger, at rest and where the trip began") {
    const sim::VehicleState home =
        flown({thrust(2.0, {1.0, 0.0, 0.0}), thrust(4.0, {-1.0, 0.0, 0.0}), thrust(2.0, {1.0, 0.0, 0.0})});
    CHECK(home.ship_clock.value == 8.0);
    // RK4's error over eight units, 1e-11 of a trip of length 5.
    CHECK_THAT(home.event.t, WithinRel(4.0 * std::sinh(2.0), 1e-10));
    CHECK_THAT(home.event.space.x, WithinAbs(0.0, 1e-10));
    CHECK_THAT(sim::readings(home).rapidity.value, WithinAbs(0.0, 1e-10));
}

TEST_CASE("a frame that turns with its circle keeps it: w = gamma^2 Omega, a = gamma^2 Omega v") {
    constexpr double beta = 0.8;
    constexpr double angular_speed = 1.0; // Omega, radians per world time
    const double gamma2 = 1.0 / (1.0 - beta * beta);
    const double period = 2.0 * std::numbers::pi / angular_speed / std::sqrt(gamma2); // ship time
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(beta)), {1.0, 0.0, 0.0});
    const sim::FlightSegment turn{
        sim::ProperTime(period), {0.0, gamma2 * angular_speed * beta, 0.0}, {0.0, 0.0, gamma2 * angular_speed}};
    const sim::VehicleState after = sim::fly_segment(state, turn, 2.0 * rate);
    // Thrust and turn of about 3 per unit at 480 Hz for 4 units: RK4 leaves 1e-10.
    CHECK(glm::length(after.event.space) < 1e-9);
    CHECK_THAT(after.event.t, WithinRel(2.0 * std::numbers::pi / angular_speed, 1e-9));
    // In the boosted axes the ship has turned 2 pi, which is the spinor's sign; its nose points as before.
    const auto axes = sim::tetrad(after.world_from_vehicle);
    CHECK_THAT(axes[1].space.x, WithinRel(std::sqrt(gamma2), 1e-9));
    CHECK_THAT(axes[2].space.y, WithinAbs(1.0, 1e-9));
}

TEST_CASE("gyroscopes on a circle turn back by 2 pi (gamma - 1) a revolution") {
    constexpr double beta = 0.8;
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    const double period = 2.0 * std::numbers::pi / gamma;
    // Thrust towards the centre, which turns at gamma^2 Omega against gyroscopes: short pieces of constant thrust.
    constexpr int pieces = 4000;
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(beta)), {1.0, 0.0, 0.0});
    for (int i = 0; i < pieces; ++i) {
        const double angle = gamma * gamma * period * (i + 0.5) / pieces;
        const glm::dvec3 inward = gamma * gamma * beta * glm::dvec3(-std::sin(angle), std::cos(angle), 0.0);
        state = sim::step(state, sim::ProperTime(period / pieces), {inward, {}});
    }
    const sim::BoostAndRotation frame =
        sim::split(sim::world_from_head(state.world_from_vehicle, glm::dquat(1.0, 0.0, 0.0, 0.0)));
    const double turned = std::atan2(frame.boosted_from_head[0].y, frame.boosted_from_head[0].x);
    const double expected = std::remainder(-2.0 * std::numbers::pi * (gamma - 1.0), 2.0 * std::numbers::pi);
    // Midpoint pieces are of second order: (10/4000)^2 of a turn of four radians.
    CHECK_THAT(turned, WithinAbs(expected, 1e-5));
}

TEST_CASE("two boosts at right angles turn the ship by the Thomas-Wigner angle") {
    for (const double xi : {0.1, 1.0, 4.0}) {
        const auto frame = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(xi), {1.0, 0.0, 0.0}) *
                           sim::boost<sim::Vehicle, sim::Head>(sim::Rapidity(xi), {0.0, 1.0, 0.0});
        const glm::dmat3 rotation = sim::split(frame).boosted_from_head;
        // tan(angle/2) = tanh(xi_1/2) tanh(xi_2/2); a few roundings.
        const double expected = 2.0 * std::atan(std::pow(std::tanh(0.5 * xi), 2.0));
        CHECK_THAT(std::abs(std::atan2(rotation[0].y, rotation[0].x)), WithinAbs(expected, 4e-15));
    }
}

TEST_CASE("out to gamma 2.4e8 and back to rest") {
    const sim::VehicleState peak = flown({thrust(20.0, {0.0, 0.0, -1.0})});
    CHECK_THAT(sim::readings(peak).gamma, WithinRel(std::cosh(20.0), 1e-11)); // RK4's error in xi, 3e-12
    const sim::VehicleState back = sim::fly_segment(peak, thrust(20.0, {0.0, 0.0, 1.0}), rate);
    // Half the square of a rapidity left over of gamma * 2e-16: 1e-15.
    CHECK(sim::readings(back).gamma_minus_one < 2e-14);
}

TEST_CASE("a thrust too small for the last digit of Lambda still adds up, along every axis") {
    for (const glm::dvec3& along :
         {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, -1.0)}) {
        constexpr double a = 1e-15; // each tick changes Lambda by 2e-18
        sim::ControlFrame control;
        control.proper_acceleration = a * along;
        sim::VehicleState state;
        for (int i = 0; i < 1'000'000; ++i) {
            state = sim::advance(state, {}, control);
        }
        const double tau = 1e6 / rate;
        // A velocity of 4e-12, read from entries of Lambda near 1 and so to 1.1e-16 a factor; its path likewise.
        const glm::dvec3 u = sim::four_velocity(state.world_from_vehicle).space;
        CHECK(glm::length(u - a * tau * along) < 2.3e-16);
        CHECK(glm::length(state.event.space - 0.5 * a * tau * tau * along) < 1.2e-16 * tau);
        CHECK_THAT(state.event.t, WithinRel(tau, 1e-15));
    }
}

TEST_CASE("the tetrad stays orthonormal and the determinant one") {
    sim_tests::RandomFrames random;
    sim::VehicleState state;
    for (int i = 0; i < 20; ++i) {
        const sim::FlightSegment segment{sim::ProperTime(0.5), 0.7 * random.unit(), 2.0 * random.unit()};
        state = sim::fly_segment(state, segment, rate);
    }
    const auto axes = sim::tetrad(state.world_from_vehicle);
    const double gamma = axes[0].t;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const double expected = i != j ? 0.0 : (i == 0 ? -1.0 : 1.0);
            // Products of components as large as gamma.
            CHECK_THAT(sim::dot(axes[i], axes[j]), WithinAbs(expected, 4e-15 * gamma * gamma));
        }
    }
    const sim::Complex det = determinant(state.world_from_vehicle.spin);
    CHECK(std::hypot(det.re - 1.0, det.im) < 2e-15 * gamma);
}

TEST_CASE("the error falls by 16 when the step is halved") {
    const sim::FlightSegment corkscrew{sim::ProperTime(2.0), {1.5, -0.5, 0.25}, {0.3, -1.2, 0.9}};
    const sim::VehicleState truth = sim::fly_segment({}, corkscrew, 4096.0);
    const auto error = [&](double steps_per_unit) {
        const sim::VehicleState state = sim::fly_segment({}, corkscrew, steps_per_unit);
        return glm::length(state.event.space - truth.event.space);
    };
    for (const double coarse : {30.0, 60.0, 120.0}) {
        const double ratio = error(coarse) / error(2.0 * coarse);
        CHECK(ratio > 15.0); // the fifth-order term is a few per cent at 30 Hz
        CHECK(ratio < 17.0);
    }
}

TEST_CASE("a segment of whole ticks is the flight a pilot would fly, to the last bit") {
    sim::ControlFrame control;
    control.proper_acceleration = {0.3, 0.1, -1.0};
    control.angular_velocity = {0.2, -0.4, 0.1};
    sim::VehicleState piloted;
    for (int i = 0; i < 240; ++i) {
        piloted = sim::advance(piloted, {}, control);
    }
    const sim::VehicleState scripted =
        flown({{sim::ProperTime(1.0), control.proper_acceleration, control.angular_velocity}});
    CHECK(scripted.event == piloted.event);
    CHECK(scripted.world_from_vehicle.spin == piloted.world_from_vehicle.spin);
    CHECK(scripted.ship_clock == piloted.ship_clock);
}

TEST_CASE("limits hold on each axis, and boost raises the thrust's alone") {
    sim::VehicleSettings settings = limited(0.5);
    settings.maximum_turn_rate = glm::dvec3(0.25);
    settings.boost_factor = 3.0;
    sim::ControlFrame control;
    control.proper_acceleration = {9.0, -9.0, 0.1};
    control.angular_velocity = {1.0, -0.1, -1.0};
    const sim::VehicleState plain = sim::advance({}, settings, control);
    CHECK(plain.felt_acceleration == glm::dvec3(0.5, -0.5, 0.1));
    CHECK(plain.angular_velocity == glm::dvec3(0.25, -0.1, -0.25));
    control.buttons = sim::ControlFrame::boost;
    const sim::VehicleState boosted = sim::advance({}, settings, control);
    CHECK(boosted.felt_acceleration == glm::dvec3(1.5, -1.5, 0.1));
    CHECK(boosted.angular_velocity == plain.angular_velocity);
}

TEST_CASE("the brake brings the ship to rest from any motion and then lets go") {
    sim_tests::RandomFrames random;
    for (const double limit : {0.5, 40.0, std::numeric_limits<double>::infinity()}) {
        for (const double turn : {0.0, 1.5}) {
            sim::VehicleState state;
            state.world_from_vehicle = random.frame<sim::World, sim::Vehicle>(3.0);
            sim::ControlFrame control;
            control.buttons = sim::ControlFrame::brake;
            control.angular_velocity = {turn, 0.0, -turn};
            double rapidity = 3.0;
            for (int i = 0; i < 2000; ++i) {
                state = sim::advance(state, limited(limit), control);
                const double now = sim::readings(state).rapidity.value;
                // Never faster than before; the last ticks tremble within the roundings of Lambda.
                CHECK(now <= rapidity + 1e-14);
                CHECK(sim::readings(state).felt_acceleration <= std::sqrt(3.0) * limit);
                rapidity = now;
            }
            CHECK(rapidity < 1e-14); // gamma - 1 = 5e-29
            CHECK(state.felt_acceleration == glm::dvec3(0.0));
        }
    }
}

TEST_CASE("instruments keep their precision when beta reads 1") {
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(25.0), {0.0, 0.0, -1.0});
    const sim::Readings fast = sim::readings(state);
    // exp of a rapidity that has an absolute error of a rounding of 25.
    CHECK_THAT(fast.one_minus_beta, WithinRel(2.0 * std::exp(-50.0), 2e-14));
    CHECK_THAT(fast.wavelength_ratio_ahead, WithinRel(std::exp(-25.0), 2e-14));
    CHECK(fast.motion_in_vehicle.z == -1.0);
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(1e-9), {1.0, 0.0, 0.0});
    // Lambda holds 5e-10 next to 1: relative precision 1e-16 / 5e-10.
    CHECK_THAT(sim::readings(state).gamma_minus_one, WithinRel(5e-19, 1e-6));
}

TEST_CASE("a snap turn turns the ship at once by just its angle, whatever its limits, and nothing else") {
    sim::VehicleSettings settings;
    settings.maximum_turn_rate = glm::dvec3(0.5);
    settings.maximum_turn_acceleration = glm::dvec3(0.1);
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(2.0), {0.6, 0.0, -0.8});
    for (const double degrees : {15.0, 30.0, 45.0, 90.0}) {
        const double angle = degrees / 180.0 * std::acos(-1.0);
        sim::ControlFrame control;
        control.angular_velocity = {0.0, angle * settings.tick_rate, 0.0};
        control.buttons = sim::ControlFrame::snap_turn;
        const sim::VehicleState after = sim::advance(state, settings, control);
        const auto turned = sim::inverse(state.world_from_vehicle) * after.world_from_vehicle;
        // The nose goes from -z towards -x, exactly: a few roundings of matrices of norm e^(xi/2).
        const glm::dvec3 nose = (turned * sim::FourVector<sim::Vehicle>{0.0, {0.0, 0.0, -1.0}}).space;
        CHECK(glm::distance(nose, glm::dvec3(-std::sin(angle), 0.0, -std::cos(angle))) < 1e-14);
        CHECK(sim::rapidity(turned).value < 1e-14);
        CHECK(after.angular_velocity == glm::dvec3(0.0));
        const sim::VehicleState coasted = sim::advance(state, settings, {});
        CHECK(std::abs(after.event.t - coasted.event.t) < 1e-16); // a rounding of the step's sum
        CHECK(glm::distance(after.event.space, coasted.event.space) < 1e-15);
    }
    // Thrust in that tick is along the new axes.
    sim::ControlFrame thrust;
    thrust.angular_velocity = {0.0, 0.5 * std::acos(-1.0) * settings.tick_rate, 0.0};
    thrust.proper_acceleration = {0.0, 0.0, -1.0};
    thrust.buttons = sim::ControlFrame::snap_turn;
    const sim::VehicleState pushed = sim::advance(sim::VehicleState(), settings, thrust);
    CHECK(sim::four_velocity(pushed.world_from_vehicle).space.x < -0.99 / settings.tick_rate);
}

#include "sim/frequency_ratio.h"
#include "sim/retarded.h"
#include "sim/ship_world_line.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <glm/geometric.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using sim_tests::RandomFrames;

namespace {

constexpr double tick = 1.0 / 240.0;

sim::VehicleState flown(sim::VehicleState state, sim::ShipWorldLine& line, const sim::Drive& drive, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        state = sim::step(state, sim::ProperTime(tick), drive);
        line.extend(state);
    }
    return state;
}

} // namespace

TEST_CASE("a coasting ship is seen where the closed form of inertial motion says, at any speed") {
    RandomFrames random;
    for (const double rapidity : {0.0, 0.5, 1.5, 5.0}) {
        sim::VehicleState state;
        state.event = {0.0, 2.0 * random.unit()};
        state.world_from_vehicle = random.frame<sim::World, sim::Vehicle>(rapidity);
        sim::ShipWorldLine line(state);
        flown(state, line, {}, 300);
        CHECK(line.pieces() == 1);
        const sim::FourVector<sim::World> u = sim::four_velocity(state.world_from_vehicle);
        for (int i = 0; i < 30; ++i) {
            const glm::dvec3 point = 0.3 * random.unit();
            // Before its start, during the flight and after its end alike.
            const sim::Event eye{random.uniform(-20.0, 30.0), random.uniform(0.0, 9.0) * random.unit()};
            const sim::Event at_zero = state.event + state.world_from_vehicle * sim::FourVector<sim::Vehicle>{0, point};
            const glm::dvec3 velocity = u.space / u.t;
            const sim::Emission expected =
                sim::retarded_emission({at_zero.space - at_zero.t * velocity, velocity}, eye);
            const sim::SeenShipPoint seen = line.seen(point, eye);
            // A ship that flees at gamma stretches what rounds at the eye's event by up to 2 gamma^2.
            const double rounding = 1e-15 * u.t * u.t * (30.0 + std::abs(expected.event.t));
            CHECK_THAT(glm::length(seen.event.space - expected.event.space), WithinAbs(0.0, rounding));
            CHECK_THAT(seen.event.t, WithinAbs(expected.event.t, rounding));
            // D's relative change with the direction is at most sinh of the rapidity.
            CHECK_THAT(seen.wavelength_ratio, WithinRel(expected.wavelength_ratio, 1e-13 * u.t * u.t));
        }
    }
}

TEST_CASE("a ship under constant thrust, and each point ahead and behind, is seen on its hyperbola") {
    const double a = 0.7;
    sim::VehicleState state;
    sim::ShipWorldLine line(state);
    flown(state, line, {{0.0, 0.0, -a}, {}}, 720); // ahead is -z
    RandomFrames random;
    for (int i = 0; i < 60; ++i) {
        const double ahead = random.uniform(-0.5, 0.5);
        // The light leaves at a moment of the flight; where it arrives is chosen, and the moment found again.
        const double clock = random.uniform(0.05, 2.95);
        const double radius = 1.0 / a + ahead;
        const glm::dvec3 from(0.0, 0.0, -(radius * std::cosh(a * clock) - 1.0 / a));
        const double time = radius * std::sinh(a * clock);
        const double delay = random.uniform(0.01, 20.0);
        const glm::dvec3 n = random.unit();
        const sim::Event eye{time + delay, from - delay * n};
        const sim::SeenShipPoint seen = line.seen({0.0, 0.0, -ahead}, eye);
        // RK4's error over three clock units is 1e-11 (DESIGN), the slope of the light cone at most e^2.1.
        CHECK_THAT(seen.ship.ship_clock.value, WithinAbs(clock, 2e-10));
        CHECK_THAT(glm::length(seen.event.space - from), WithinAbs(0.0, 2e-9));
        const double expected = std::cosh(a * clock) - n.z * std::sinh(a * clock);
        CHECK_THAT(seen.wavelength_ratio, WithinRel(expected, 1e-8));
    }
}

TEST_CASE("the points of a turning ship are seen where they were, moving as they did") {
    const double w = 2.0;
    sim::VehicleState state;
    sim::ShipWorldLine line(state);
    flown(state, line, {{}, {0.0, w, 0.0}}, 720);
    const glm::dvec3 point(0.2, 0.0, 0.0);
    const double clock = 1.3;
    const glm::dvec3 at(0.2 * std::cos(w * clock), 0.0, -0.2 * std::sin(w * clock));
    const glm::dvec3 velocity(-0.2 * w * std::sin(w * clock), 0.0, -0.2 * w * std::cos(w * clock));
    const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 2.0, -0.5));
    const sim::SeenShipPoint seen = line.seen(point, {clock + 3.0, at - 3.0 * n});
    CHECK_THAT(seen.ship.ship_clock.value, WithinAbs(clock, 1e-11)); // RK4's phase
    CHECK_THAT(glm::length(seen.event.space - at), WithinAbs(0.0, 1e-11));
    const double gamma = 1.0 / std::sqrt(1.0 - 0.16);
    CHECK_THAT(seen.wavelength_ratio, WithinRel(gamma * (1.0 + glm::dot(n, velocity)), 1e-10));
}

TEST_CASE("a ship that comes at 0.9 c is seen to come in a tenth of the time it takes") {
    sim::VehicleState state;
    state.event.space = {0.0, 0.0, -90.0};
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(0.9)), {0.0, 0.0, 1.0});
    const sim::ShipWorldLine line(state);
    const double first_light = 90.0;
    const sim::SeenShipPoint far = line.seen(glm::dvec3(0.0), {first_light, glm::dvec3(0.0)});
    CHECK_THAT(far.event.space.z, WithinAbs(-90.0, 1e-11));
    const sim::SeenShipPoint near = line.seen(glm::dvec3(0.0), {first_light + 9.0, glm::dvec3(0.0)});
    // It takes 90/0.9 = 100 by the world's clock; 0.1 of those bring 9/0.1 = 90 of the way's emissions.
    CHECK_THAT(near.event.t - far.event.t, WithinAbs(9.0 / (1.0 - 0.9), 1e-10));
    CHECK_THAT(near.wavelength_ratio, WithinRel(std::sqrt(0.1 / 1.9), 1e-13));
}

TEST_CASE("a world line gives back every tick that was flown, in few pieces") {
    RandomFrames random;
    sim::VehicleState state;
    state.event.space = {3.0, -2.0, 1.0};
    sim::ShipWorldLine line(state);
    std::vector<sim::VehicleState> ticks{state};
    for (int leg = 0; leg < 12; ++leg) {
        const sim::Drive drive{random.uniform(0.0, 1.0) * random.unit(), random.uniform(0.0, 2.0) * random.unit()};
        for (int i = 0; i < 60; ++i) {
            state = sim::step(state, sim::ProperTime(tick), drive);
            line.extend(state);
            ticks.push_back(state);
        }
    }
    CHECK(line.pieces() < ticks.size() / 4);
    for (const sim::VehicleState& flown_state : ticks) {
        const sim::WorldLinePoint point = line.at(flown_state.ship_clock);
        const sim::Event apart = point.event - flown_state.event;
        CHECK_THAT(std::abs(apart.t) + glm::length(apart.space), WithinAbs(0.0, 1e-10)); // 1e-12 of up to 20, and sums
        CHECK(sim::frobenius2(point.world_from_vehicle.spin - flown_state.world_from_vehicle.spin) < 1e-20);
        // As the world's clock passes.
        CHECK_THAT(line.at_world_time(sim::CoordinateTime(flown_state.event.t)).value,
                   WithinAbs(flown_state.ship_clock.value, 1e-10));
    }
}

TEST_CASE("light's frequency for a fast source loses no digits straight behind it") {
    for (const double rapidity : {1.0, 10.0, 18.0}) {
        const sim::FourVector<sim::World> u{std::cosh(rapidity), {0.0, 0.0, std::sinh(rapidity)}};
        // The four-velocity's own rounding is all that is lost.
        CHECK_THAT(sim::frequency_ratio(u, {{0.0, 0.0, 1.0}}), WithinRel(std::exp(rapidity), 1e-14));
        CHECK_THAT(sim::frequency_ratio(u, {{0.0, 0.0, -1.0}}), WithinRel(std::exp(-rapidity), 1e-14));
    }
}

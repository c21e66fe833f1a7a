#include "sim/far_event.h"
#include "sim/flight_script.h"

#include <catch2/catch_test_macros.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <random>

namespace {

constexpr double metres_per_light_year = 9.4607304725808e15;
constexpr double seconds_per_year = 31557600.0;

/// Years and light-years.
sim::VehicleState flown(sim::VehicleState state, double seconds, const glm::dvec3& metres_per_second_squared) {
    constexpr double unit = metres_per_light_year / (seconds_per_year * seconds_per_year);
    const double years = seconds / seconds_per_year;
    return sim::fly_segment(state, {sim::ProperTime(years), metres_per_second_squared / unit, {}}, 240.0 / years);
}

} // namespace

TEST_CASE("a sum and its rounding are the exact sum") {
    __extension__ using Wide = __int128;
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        // Whole numbers of up to 53 bits, one of them up to 2^60 times larger: 128 bits hold what they sum to.
        const auto small = static_cast<std::int64_t>(random()) >> 11u;
        const auto large = (static_cast<std::int64_t>(random()) >> 11u) >> random() % 53;
        const auto shift = static_cast<int>(random() % 60);
        const double a = static_cast<double>(small);
        const double b = std::ldexp(static_cast<double>(large), shift);
        const sim::ExactSum exact = sim::exact_sum(a, b);
        REQUIRE(static_cast<Wide>(exact.sum) + static_cast<Wide>(exact.error) ==
                static_cast<Wide>(small) + static_cast<Wide>(large) * (Wide{1} << shift));
        REQUIRE(exact.sum == a + b);
    }
}

TEST_CASE("the origin moves without moving the event") {
    // Steps of whole multiples of 2^-70 whose sums near zero are exact; far away, a double steps by 2^-43.
    const sim::FarEvent start{{1000.0, {-1000.0, 999.0, 1e-3}}, {}};
    std::mt19937_64 random(2);
    const auto step = [&random] {
        return std::ldexp(static_cast<double>(static_cast<std::int64_t>(random()) >> 33u), -70);
    };
    sim::FarEvent far = start;
    sim::Event near;
    int moves = 0;
    for (int i = 0; i < 100000; ++i) {
        const sim::Event by{step(), {step(), step(), step()}};
        const sim::FarEvent next = sim::displaced(far, by);
        moves += next.origin == far.origin ? 0 : 1;
        far = next;
        near = near + by;
        // The origin is the nearest double: adding the offset changes nothing.
        REQUIRE(far.origin.space.x + far.offset.space.x == far.origin.space.x);
    }
    CHECK(sim::displacement(start, far) == near);
    CHECK(moves > 1000); // otherwise nothing was shown
}

TEST_CASE("another unit of length keeps the small distances far away") {
    const sim::FarEvent here = sim::displaced({{10.0, {1e3, -2e3, 5e2}}, {}}, {1e-17, {3e-18, 1e-19, -2e-17}});
    const sim::Event apart{1e-18, {2e-18, -3e-18, 7e-19}};
    const double factor = 1.0 / 3.0;
    const sim::Event scaled =
        sim::displacement(sim::scaled(here, factor), sim::scaled(sim::displaced(here, apart), factor));
    // Twice a double's digits of a thousand: 1e3 * 2^-105.
    CHECK(glm::length(scaled.space - factor * apart.space) < 1e-28);
    CHECK(std::abs(scaled.t - factor * apart.t) < 1e-28);
}

TEST_CASE("after a trip of 1,000 light-years a metre's manoeuvre is resolved to a twentieth of a millimetre") {
    // 1 g in light-years per year squared. Half the way out, the other half braking.
    constexpr double g = 9.80665 * seconds_per_year * seconds_per_year / metres_per_light_year;
    const double half = std::acosh(1.0 + 500.0 * g) / g;
    sim::VehicleState ship = sim::fly_segment({}, {sim::ProperTime(half), {0.6 * g, -0.8 * g, 0.0}, {}}, 240.0);
    ship = sim::fly_segment(ship, {sim::ProperTime(half), {-0.6 * g, 0.8 * g, 0.0}, {}}, 240.0);
    REQUIRE(std::abs(glm::length(ship.event.space) - 1000.0) < 1e-6);

    sim::VehicleState moved = ship;
    sim::Event expected; // metres and seconds from where the manoeuvres begin
    const glm::dvec3 drift =
        sim::four_velocity(ship.world_from_vehicle).space * metres_per_light_year / seconds_per_year;
    for (const glm::dvec3& way : {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, -0.5), glm::dvec3(-0.25, 2.0, 0.0)}) {
        moved = flown(moved, 1.0, way);
        moved = flown(moved, 1.0, -way);
        expected.space = expected.space + way + 2.0 * drift;
        const glm::dvec3 metres =
            sim::displacement(sim::far_event(ship), sim::far_event(moved)).space * metres_per_light_year;
        // What braking left, a few roundings of Lambda at the trip's peak gamma of 517, drifts along and is counted.
        // Thrust along z adds to entries of Lambda near 1, which may round the same way in each of 240 steps:
        // 240 * 1.1e-16 c for a second is 8 micrometres.
        CHECK(glm::length(metres - expected.space) < 5e-5);
    }
    // The nearest double alone steps by a kilometre there.
    CHECK(moved.event.space.x == ship.event.space.x);
    CHECK(moved.event.space.y == ship.event.space.y);
}

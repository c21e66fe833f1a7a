#include "sim/spacetime/deflection_table.h"

#include "sim/spacetime/observer.h"

#include <catch2/catch_test_macros.hpp>

#include <glm/geometric.hpp>

#include <cmath>

namespace {

struct Eye {
    sim::AnySpacetime spacetime;
    sim::Components<double> event;
    sim::Tetrad tetrad;
};

Eye eye_in(const char* name, const sim::ParameterValues& values, sim::ObserverKind kind, const glm::dvec3& place,
           const glm::dvec3& beta = glm::dvec3(0.0)) {
    Eye eye{sim::make_spacetime("test", name, values), {0.0, place.x, place.y, place.z}, {}};
    eye.tetrad = std::visit(
        [&](const auto& spacetime) {
            const auto velocity = sim::observer_velocity(spacetime, eye.event, kind);
            return sim::boosted(sim::camera_tetrad(spacetime, eye.event, velocity.value(),
                                                   glm::normalize(glm::dvec3(-0.8, 0.3, -0.2)), {0.1, 0.0, 1.0}),
                                beta);
        },
        eye.spacetime);
    return eye;
}

/// Directions over the whole sky.
std::vector<glm::dvec3> directions(int count) {
    std::vector<glm::dvec3> all;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double across = std::sqrt(1.0 - z * z);
        all.emplace_back(across * std::cos(2.4 * i), across * std::sin(2.4 * i), z);
    }
    return all;
}

} // namespace

TEST_CASE("a table of deflections says what every traced ray says, to 1e-6 radian") {
    using enum sim::ObserverKind;
    const std::vector<Eye> eyes{
        eye_in("schwarzschild", {}, at_rest, {8.0, 3.0, -2.0}),
        eye_in("schwarzschild", {}, free_fall, {0.0, 2.5, 1.0}),
        eye_in("schwarzschild", {}, free_fall, {1.2, 0.3, 0.1}), // within the horizon
        eye_in("schwarzschild", {}, circular_orbit, {0.0, 7.0, 0.0}),
        eye_in("schwarzschild", {{"mass", 2.0}}, at_rest, {9.0, 1.0, 4.0}, {0.3, -0.5, 0.6}),
        eye_in("schwarzschild", {}, free_fall, {1.2, 0.3, 0.1}, {0.5, 0.1, 0.2}),
        eye_in("reissner-nordstroem", {{"charge", 0.8}}, at_rest, {5.0, 0.0, 4.0}),
        eye_in("wormhole", {}, at_rest, {2.0, -1.0, 0.5}),
        eye_in("wormhole", {}, at_rest, {0.1, 0.1, 0.2}, {0.0, 0.6, 0.0}), // on the far side
        eye_in("alcubierre", {{"speed", 0.5}}, free_fall, {0.0, 0.0, 0.0}),
        eye_in("alcubierre", {{"speed", 2.5}}, free_fall, {0.0, 0.0, 0.0}),
        eye_in("alcubierre", {{"speed", 0.9}}, free_fall, {0.3, 0.0, 0.0}, {0.2, 0.0, 0.1}),
    };
    const std::vector<glm::dvec3> seen = directions(2000);
    for (const Eye& eye : eyes) {
        INFO("spacetime " << eye.spacetime.index() << " at " << eye.event.x << " " << eye.event.y);
        REQUIRE(sim::DeflectionTable::fits(eye.spacetime, eye.event));
        const sim::DeflectionTable table(eye.spacetime, eye.event, eye.tetrad, {});
        CHECK(table.error() <= 1e-7);
        std::vector<sim::SkyRay> found(seen.size());
        table.trace(seen, found);
        // The eye's own rays, not those of the falling observer whom the table asked.
        sim::SkyTracer tracer(eye.spacetime, eye.event, eye.tetrad, {});
        tracer.choose_step(seen, 1e-9, 0.9);
        std::vector<sim::SkyRay> traced(seen.size());
        tracer.trace(seen, traced);
        int compared = 0;
        int different = 0;
        int beyond = 0;
        double frequency_off = 0.0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (traced[i].outcome != found[i].outcome || traced[i].infinity.side != found[i].infinity.side) {
                ++different;
            } else if (traced[i].outcome == sim::RayOutcome::escaped) {
                ++compared;
                beyond += sim::angle_between(traced[i].infinity.direction, found[i].infinity.direction) < 1e-6 ? 0 : 1;
                frequency_off =
                    std::max(frequency_off, std::abs(found[i].infinity.frequency / traced[i].infinity.frequency - 1.0));
            }
        }
        CHECK(compared > 250);
        CHECK(different == 0);
        // The traced rays themselves, at the ring, are known no better.
        CHECK(beyond <= 2);
        CHECK(frequency_off < 1e-5);
    }
}

TEST_CASE("a hole that turns and an eye beside a bubble's path have no table") {
    CHECK_FALSE(sim::DeflectionTable::fits(sim::make_spacetime("test", "kerr", {}), {0.0, 10.0, 0.0, 0.0}));
    CHECK_FALSE(sim::DeflectionTable::fits(sim::make_spacetime("test", "alcubierre", {}), {0.0, 1.0, 0.1, 0.0}));
    CHECK_FALSE(sim::DeflectionTable::fits(sim::make_spacetime("test", "plane-wave", {}), {0.0, 1.0, 0.0, 0.0}));
}

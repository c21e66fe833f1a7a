#include "render/offline/traced/deflection_table.h"

#include "render/offline/traced/lane_rays.h"
#include "sim/spacetime/observer.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;

namespace {

struct Eye {
    sim::AnySpacetime spacetime;
    sim::Components<double> event;
    sim::Tetrad tetrad;
};

Eye eye_in(const char* name, sim::ObserverKind kind, const glm::dvec3& place) {
    Eye eye{sim::make_spacetime("test", name, {}), {0.0, place.x, place.y, place.z}, {}};
    eye.tetrad = std::visit(
        [&](const auto& spacetime) {
            const auto velocity = sim::observer_velocity(spacetime, eye.event, kind);
            return sim::camera_tetrad(spacetime, eye.event, *velocity, glm::normalize(glm::dvec3(-0.8, 0.3, -0.2)),
                                      {0.1, 0.0, 1.0});
        },
        eye.spacetime);
    return eye;
}

/// Directions over the whole sky.
std::vector<glm::dvec3> directions() {
    constexpr int count = 4000;
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
    const std::vector<Eye> eyes{
        eye_in("schwarzschild", sim::ObserverKind::at_rest, {8.0, 3.0, -2.0}),
        eye_in("schwarzschild", sim::ObserverKind::free_fall, {0.0, 2.5, 1.0}),
        eye_in("schwarzschild", sim::ObserverKind::free_fall, {1.2, 0.3, 0.1}), // within the horizon
        eye_in("reissner-nordstroem", sim::ObserverKind::at_rest, {5.0, 0.0, 4.0}),
        eye_in("wormhole", sim::ObserverKind::at_rest, {2.0, -1.0, 0.5}),
    };
    for (const Eye& eye : eyes) {
        const auto symmetry = render::radial_symmetry(eye.spacetime, eye.event, eye.tetrad);
        REQUIRE(symmetry);
        sim::RaySettings settings;
        const render::DeflectionTable table(sim::SkyTracer(eye.spacetime, eye.event, eye.tetrad, settings), *symmetry);
        CHECK(table.error() < 1e-7);
        const std::vector<glm::dvec3> seen = directions();
        std::vector<render::TracedRay> by_table(seen.size());
        table.trace(seen, by_table, 0);
        sim::SkyTracer tracer(eye.spacetime, eye.event, eye.tetrad, settings);
        tracer.choose_step(seen, 1e-9, 0.9);
        std::vector<sim::SkyRay> traced(seen.size());
        tracer.trace(seen, traced);
        int compared = 0;
        int different = 0;
        int beyond = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const render::TracedRay ray = render::traced_ray(traced[i].outcome, traced[i].infinity, traced[i].steps);
            if (ray.fate != by_table[i].fate) {
                ++different;
                continue;
            }
            if (render::is_sky(ray.fate)) {
                ++compared;
                const double off = glm::length(ray.direction - by_table[i].direction);
                beyond += off < 1e-6 ? 0 : 1;
                CHECK_THAT(by_table[i].wavelength_ratio / ray.wavelength_ratio, WithinAbs(1.0, 1e-7));
            }
        }
        INFO("spacetime " << eye.spacetime.index() << " at " << eye.event.x);
        CHECK(compared > 500);
        CHECK(different == 0);
        // The traced rays themselves, at the ring, are known no better.
        CHECK(beyond <= 4);
    }
}

TEST_CASE("an eye that moves across the radius, or a hole that turns, has no table") {
    const Eye orbit = eye_in("schwarzschild", sim::ObserverKind::circular_orbit, {10.0, 0.0, 0.0});
    CHECK_FALSE(render::radial_symmetry(orbit.spacetime, orbit.event, orbit.tetrad));
    const Eye kerr = eye_in("kerr", sim::ObserverKind::at_rest, {10.0, 0.0, 0.0});
    CHECK_FALSE(render::radial_symmetry(kerr.spacetime, kerr.event, kerr.tetrad));
}

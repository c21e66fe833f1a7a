#include "sim/look.h"
#include "sim/lorentz.h"

#include <catch2/catch_test_macros.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace shared {
using glm::dot;
using glm::vec2;
using glm::vec3;
namespace {
#include "render/shaders/shared/warp.glsl"
}
} // namespace shared

TEST_CASE("the shader's aberration and Doppler agree with spinors in double precision") {
    for (const double rapidity : {0.0, 0.3, 1.0, 3.0, 6.0, 10.0}) {
        const auto world_from_head = sim::boost<sim::World, sim::Head>(sim::Rapidity(rapidity), {0.0, 0.0, 1.0});
        for (int i = 0; i <= 200; ++i) {
            for (const double turn : {0.1, 2.0, 4.5}) {
                const double angle = std::acos(-1.0) * i / 200.0;
                const glm::dvec3 exact_ray(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                                           std::cos(angle));
                // Compared for the ray that single precision holds: what rounding the ray costs is a matter of pixels.
                const glm::vec3 ray(exact_ray);
                const shared::SeenLight seen = shared::see_along_z(ray, static_cast<float>(std::exp(rapidity)));
                const sim::SeenLight truth = sim::see(world_from_head, {glm::normalize(glm::dvec3(ray))});
                CAPTURE(rapidity, angle, turn);
                const double d = static_cast<double>(seen.wavelength_ratio);
                // Single precision, a dozen operations without cancellation. Near the axis ahead D is e^-xi + theta^2
                // e^xi / 4: the ray's own length, 1 to 6e-8, does not enter at that order.
                CHECK(std::abs(d / truth.wavelength_ratio - 1.0) < 2e-6);
                const glm::dvec3 direction = glm::dvec3(seen.direction_times_ratio) / d;
                CHECK(glm::distance(direction, truth.world_direction) < 2e-6);
            }
        }
    }
}

TEST_CASE("a tile's texture coordinates are those of the projective map, at any length of the direction") {
    const shared::vec3 x(1.0f, -3.0f, 0.3f);
    const shared::vec3 y(2.0f, 1.5f, 0.7f);
    const shared::vec3 depth(0.1f, 0.2f, 1.1f);
    for (const float length : {1.0f, 4.0f, 1e-4f}) {
        const shared::vec2 at = shared::tile_coordinates(x, y, depth, length * shared::vec3(0.2f, -0.3f, 0.9f));
        // (0.2 + 0.9 + 0.27, 0.4 - 0.45 + 0.63) / (0.02 - 0.06 + 0.99), to single precision
        CHECK(glm::distance(at, shared::vec2(1.37f / 0.95f, 0.58f / 0.95f)) < 1e-6f);
    }
}

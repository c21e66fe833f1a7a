#include "render/offline/traced/projection.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using content::Projection;
using std::numbers::pi;

namespace {

glm::dvec3 seen(const render::CameraLens& lens, double x, double y) {
    const auto direction = render::head_direction(lens, {x, y});
    REQUIRE(direction);
    return *direction;
}

/// Solid angle of all pixels, rows and columns sampled at their centres.
double whole_solid_angle(const render::CameraLens& lens) {
    double sum = 0.0;
    for (int row = 0; row < lens.height; ++row) {
        for (int column = 0; column < lens.width; ++column) {
            if (render::head_direction(lens, {column + 0.5, row + 0.5})) {
                sum += render::pixel_solid_angle(lens, {column + 0.5, row + 0.5});
            }
        }
    }
    return sum;
}

} // namespace

TEST_CASE("every projection looks ahead in its middle, with x to the right and y up") {
    for (const Projection projection : {Projection::perspective, Projection::fisheye, Projection::equirectangular}) {
        const render::CameraLens lens{projection, 1.0, 200, 100};
        CHECK(glm::length(seen(lens, 100.0, 50.0) - glm::dvec3(0.0, 0.0, -1.0)) < 1e-15);
        CHECK(seen(lens, 110.0, 50.0).x > 0.0);
        CHECK(seen(lens, 100.0, 40.0).y > 0.0);
        CHECK_THAT(glm::length(seen(lens, 123.0, 31.0)), WithinAbs(1.0, 1e-15));
    }
}

TEST_CASE("angles lie where each projection's law puts them") {
    const double field = 1.2;
    // Perspective: tangents. The picture's edge is half the field of view from the axis.
    const glm::dvec3 edge = seen({Projection::perspective, field, 200, 100}, 200.0, 50.0);
    CHECK_THAT(std::atan2(edge.x, -edge.z), WithinAbs(0.5 * field, 1e-14));
    // Fisheye: even in the angle, also beyond a half turn.
    const render::CameraLens fisheye{Projection::fisheye, 1.5 * pi, 300, 300};
    for (const double share : {0.1, 0.5, 0.9}) {
        const glm::dvec3 direction = seen(fisheye, 150.0 + 150.0 * share, 150.0);
        CHECK_THAT(std::atan2(direction.x, -direction.z), WithinAbs(share * 0.75 * pi, 1e-14));
    }
    CHECK_FALSE(render::head_direction(fisheye, {1.0, 1.0}));
    // Equirectangular: the zenith above, straight right a quarter of the width from the middle.
    const render::CameraLens sky{Projection::equirectangular, 0.0, 400, 200};
    CHECK(glm::length(seen(sky, 77.0, 0.0) - glm::dvec3(0.0, 1.0, 0.0)) < 1e-14);
    CHECK(glm::length(seen(sky, 300.0, 100.0) - glm::dvec3(1.0, 0.0, 0.0)) < 1e-14);
}

TEST_CASE("the pixels' solid angles are what their projection covers") {
    // A midpoint rule over 200 pixels: relative error about (1/200)^2.
    CHECK_THAT(whole_solid_angle({Projection::equirectangular, 0.0, 400, 200}), WithinRel(4.0 * pi, 1e-4));
    // A square screen of 90 degrees is a face of a cube.
    CHECK_THAT(whole_solid_angle({Projection::perspective, 0.5 * pi, 200, 200}), WithinRel(4.0 * pi / 6.0, 1e-4));
    // A fisheye's circle of half angle t is a cap; its stepped rim leaves an error of a pixel's share, 1 in 200.
    CHECK_THAT(whole_solid_angle({Projection::fisheye, 2.0, 400, 400}),
               WithinRel(2.0 * pi * (1.0 - std::cos(1.0)), 2e-3));
}

#include "render/offline/traced/tile_painter.h"

#include "render/colour/star_photometry.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using render::TracedChannel;

namespace {

/// Rays made by a formula.
class Formula : public render::RaySource {
  public:
    using Function = std::function<render::TracedRay(const glm::dvec3&)>;
    explicit Formula(Function function) : function_(std::move(function)) {}

    void trace(std::span<const glm::dvec3> directions, std::span<render::TracedRay> rays,
               std::size_t /*error_every*/) const override {
        for (std::size_t i = 0; i < directions.size(); ++i) {
            rays[i] = function_(directions[i]);
        }
    }

  private:
    Function function_;
};

render::TracedRay from_sky(const glm::dvec3& chart_direction, double wavelength_ratio = 1.0) {
    render::TracedRay ray;
    ray.fate = render::RayFate::sky;
    ray.direction = chart_direction;
    ray.wavelength_ratio = wavelength_ratio;
    return ray;
}

/// Head axes as chart axes: -z ahead is +y of the chart, so that a camera looking along +y with z up sees flat space.
glm::dvec3 chart_from_head(const glm::dvec3& head) {
    return {head.x, -head.z, head.y};
}

const render::TracedColour& colour() {
    static const render::TracedColour table(5762.0);
    return table;
}

double flat_magnification(const glm::dvec3& /*direction*/) {
    return 1.0;
}

render::TracedTile painted(const render::CameraLens& lens, const Formula& rays, const render::TracedSkies& skies,
                           int samples = 2) {
    const render::BundleMagnification magnification = flat_magnification;
    render::TracedTile tile;
    tile.width = lens.width;
    tile.height = lens.height;
    render::TilePainter(lens, rays, magnification, skies, colour(), samples).paint(tile);
    return tile;
}

content::Star star_at(const glm::dvec3& chart, float magnitude) {
    content::Star star;
    star.position = 10.0 * glm::normalize(glm::dvec3(chart.x, chart.z, -chart.y));
    star.visual_magnitude = magnitude;
    star.temperature = 5762.0f;
    return star;
}

double sum_of(render::TracedTile tile, TracedChannel channel) {
    double sum = 0.0;
    for (int row = 0; row < tile.height; ++row) {
        for (int column = 0; column < tile.width; ++column) {
            sum += tile.value(column, row, channel);
        }
    }
    return sum;
}

} // namespace

TEST_CASE("an edge gets more rays, and its pixels the share of it that they see") {
    // Dark to the right of a slanted line through the picture.
    const render::CameraLens lens{content::Projection::perspective, 0.6, 40, 30};
    const Formula rays([](const glm::dvec3& head) {
        render::TracedRay ray = from_sky(chart_from_head(head));
        if (head.x > 0.02 + 0.3 * head.y) {
            ray.fate = render::RayFate::captured;
        }
        return ray;
    });
    std::vector<std::string> notes;
    content::TracedSky white;
    white.colour = glm::dvec3(1.0);
    const render::SkyLight sky(white, notes);
    render::TracedTile tile = painted(lens, rays, {{&sky, nullptr}, {}});
    const double focal = 20.0 / std::tan(0.3);
    for (int row = 0; row < 30; ++row) {
        // x/f = 0.02 n + 0.3 y/f with n = |(x, y, f)|/f, to first order 1.
        const double y = 15.0 - (row + 0.5);
        double x = 0.0;
        for (int i = 0; i < 20; ++i) {
            x = 0.02 * std::sqrt(x * x + y * y + focal * focal) + 0.3 * y;
        }
        const double edge = 20.0 + x;
        for (int column = 0; column < 40; ++column) {
            const double share = std::clamp(edge - column, 0.0, 1.0);
            // 8 x 8 samples at an edge: a sixteenth of a pixel, and the line's slant of 0.3 within it.
            CHECK_THAT(
                tile.value(column, row, TracedChannel::red),
                WithinAbs(share,
                          0.05 + (share > 0 && share < 1 ? 0.15 : 0.15 * (std::abs(edge - column - 0.5) < 0.7))));
            const bool on_edge = std::abs(edge - column - 0.5) < 0.3;
            CHECK((!on_edge || tile.value(column, row, TracedChannel::rays) == 4 + 16 + 64));
        }
    }
    CHECK(tile.value(0, 0, TracedChannel::rays) == 4);
    // The lit area as a whole is far more exact than any pixel.
    double lit = 0.0;
    for (int row = 0; row < 30; ++row) {
        const double y = 15.0 - (row + 0.5);
        lit += 20.0 + 0.02 * focal + 0.3 * y;
    }
    CHECK_THAT(sum_of(tile, TracedChannel::red), WithinRel(lit, 2e-3));
}

TEST_CASE("rays that are not known are marked and counted, never black") {
    const render::CameraLens lens{content::Projection::perspective, 0.6, 8, 8};
    const Formula rays([](const glm::dvec3& head) {
        render::TracedRay ray = from_sky(chart_from_head(head));
        if (head.x > 0.0) {
            ray.fate = head.y > 0.0 ? render::RayFate::step_limit : render::RayFate::left_chart;
        } else if (head.y > 0.0) {
            ray.fate = render::RayFate::object;
            ray.light = glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        }
        return ray;
    });
    render::TracedTile tile = painted(lens, rays, {});
    CHECK(tile.value(6, 1, TracedChannel::undecided) == 1.0f);
    CHECK(tile.value(6, 6, TracedChannel::undecided) == 1.0f);
    CHECK(tile.value(1, 1, TracedChannel::undecided) == 1.0f);
    CHECK(tile.value(1, 6, TracedChannel::undecided) == 0.0f);
    CHECK(tile.value(6, 1, TracedChannel::red) == 1.0f);
    CHECK(tile.value(6, 1, TracedChannel::green) == 0.0f);
    CHECK(tile.value(6, 6, TracedChannel::outcome) == static_cast<float>(render::RayFate::left_chart));
    CHECK(tile.value(1, 1, TracedChannel::blue) == 1.0f); // the NaN itself is nowhere
}

TEST_CASE("light from infinity comes shifted by D") {
    const render::CameraLens lens{content::Projection::perspective, 0.6, 4, 4};
    std::vector<std::string> notes;
    content::TracedSky grey;
    grey.colour = glm::dvec3(0.5);
    const render::SkyLight sky(grey, notes);
    const double d = 1.3;
    const Formula rays([&](const glm::dvec3& head) { return from_sky(chart_from_head(head), d); });
    render::TracedTile tile = painted(lens, rays, {{&sky, nullptr}, {}});
    // A grey is the light's black body: half of one at T/D.
    const glm::dvec3 expected = 0.5 * colour().black_body(5762.0, d);
    CHECK_THAT(tile.value(2, 2, TracedChannel::red), WithinRel(expected.x, 1e-4));
    CHECK_THAT(tile.value(2, 2, TracedChannel::blue), WithinRel(expected.z, 1e-4));
}

TEST_CASE("a star in flat space is where it is, once, with all of its light") {
    const render::CameraLens lens{content::Projection::perspective, 0.4, 60, 40};
    const Formula rays([](const glm::dvec3& head) { return from_sky(chart_from_head(head)); });
    const glm::dvec2 place(33.37, 17.81);
    const auto towards = render::head_direction(lens, place);
    const std::vector<content::Star> stars{star_at(chart_from_head(*towards), 3.0f)};
    const render::StarField field(stars, colour(), 1.0);
    render::TracedTile tile;
    tile.width = 60;
    tile.height = 40;
    const auto images = field.images(lens, rays, flat_magnification, render::RayFate::sky, tile);
    REQUIRE(images.size() == 1);
    CHECK(glm::length(images[0].place - place) < 1e-6); // Newton's method ends at rounding
    tile = painted(lens, rays, {{}, {&field, nullptr}});
    const double pixel = render::pixel_solid_angle(lens, place);
    // A star of magnitude 3 at the temperature of white has 10^(-1.2) of magnitude 0's light; the footprint's shares
    // sum to 1 in single precision.
    const double expected = render::light_of_magnitude_zero * std::pow(10.0, -0.4 * 3.0) / pixel;
    CHECK_THAT(sum_of(tile, TracedChannel::green), WithinRel(expected, 1e-3));
}

TEST_CASE("a lens makes a star's images brighter as it enlarges the sky, and never larger") {
    // The angle from the axis is halved: solid angle times sin(t)/(sin(t/2)/2) at an image at t.
    const render::CameraLens lens{content::Projection::perspective, 0.8, 80, 60};
    const Formula rays([](const glm::dvec3& head) {
        const double angle = std::atan2(std::hypot(head.x, head.y), -head.z);
        const double scale = angle > 0.0 ? std::sin(0.5 * angle) / std::sin(angle) : 0.5;
        return from_sky(chart_from_head({scale * head.x, scale * head.y, -std::cos(0.5 * angle)}));
    });
    const glm::dvec2 place(50.2, 21.7);
    const glm::dvec3 head = *render::head_direction(lens, place);
    std::vector<render::TracedRay> ray(1);
    rays.trace(std::span(&head, 1), ray, 0);
    const render::StarField field({star_at(ray[0].direction, 4.0f)}, colour(), 1.0);
    render::TracedTile tile;
    tile.width = 80;
    tile.height = 60;
    const auto enlarged = [](const glm::dvec3& seen) {
        const double angle = std::atan2(std::hypot(seen.x, seen.y), -seen.z);
        return std::sin(angle) / (0.5 * std::sin(0.5 * angle));
    };
    const auto images = field.images(lens, rays, enlarged, render::RayFate::sky, tile);
    REQUIRE(images.size() == 1);
    CHECK(glm::length(images[0].place - place) < 1e-6);
    // Of the bundle around the image, not around the candidate half a pixel away.
    CHECK_THAT(images[0].magnification, WithinRel(enlarged(head), 1e-9));
    tile.values.assign(static_cast<std::size_t>(tile.width * tile.height) * render::traced_channel_count, 0.0f);
    field.add(images, lens, tile);
    const double unlensed = render::light_of_magnitude_zero * std::pow(10.0, -0.4 * 4.0);
    const double radiance = unlensed * enlarged(head) / render::pixel_solid_angle(lens, place);
    CHECK_THAT(sum_of(tile, TracedChannel::green), WithinRel(radiance, 1e-3)); // the footprint's shares are single
}

TEST_CASE("a checkerboard far finer than what a ray stands for is its mean") {
    CHECK_THAT(render::checkerboard_share(0.3, 0.4, 1e-4, 0.1, 0.1), WithinAbs(0.5, 1e-3));
    CHECK(render::checkerboard_share(0.5, 0.5, 1.0, 0.0, 0.0) == 1.0);
    CHECK(render::checkerboard_share(1.5, 0.5, 1.0, 0.0, 0.0) == 0.0);
    CHECK_THAT(render::checkerboard_share(1.0, 0.5, 1.0, 0.2, 0.0), WithinAbs(0.5, 1e-12)); // astride an edge
}

TEST_CASE("a panorama's mean over a wide footprint is the panorama's mean there") {
    content::Panorama stripes;
    stripes.width = 256;
    stripes.height = 128;
    for (int row = 0; row < 128; ++row) {
        for (int column = 0; column < 256; ++column) {
            stripes.radiance.emplace_back(column % 2 == 0 ? 2.0f : 0.0f);
        }
    }
    const render::PanoramaPyramid pyramid(stripes);
    const glm::dvec3 ahead(0.0, 0.0, -1.0);
    const double texel = 2.0 * std::numbers::pi / 256.0;
    // At eight texels each way the stripes are gone; along one axis alone, too, for taps do it.
    CHECK_THAT(pyramid.radiance(ahead, {8 * texel, 0, 0}, {0, 8 * texel, 0}).x, WithinAbs(1.0, 0.02));
    CHECK_THAT(pyramid.radiance(ahead, {8 * texel, 0, 0}, {0, 0.1 * texel, 0}).x, WithinAbs(1.0, 0.15));
}

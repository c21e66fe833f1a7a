#include "render/colour/star_photometry.h"

#include "sim/lorentz.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/glm.hpp>

#include <cmath>

namespace star_shader {
using namespace glm;
#include "render/shaders/shared/star.glsl"
} // namespace star_shader

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

double luminance(const render::DopplerColour& colour, const glm::dvec3& rgb) {
    return (glm::inverse(colour.white().rgb_from_xyz()) * rgb).y;
}

content::Star star_of(float magnitude, float temperature, double distance) {
    content::Star star;
    star.position = {0.0, 0.0, -distance};
    star.visual_magnitude = magnitude;
    star.temperature = temperature;
    return star;
}

} // namespace

TEST_CASE("a star's light follows magnitude and distance") {
    const render::DopplerColour colour(5762.0);
    const auto light = [&](float magnitude, double distance) {
        const auto source = render::star_source(colour, star_of(magnitude, 4200.0f, 12.0));
        return luminance(colour, render::star_light(colour, source, render::Mode::full, distance, 1.0));
    };
    CHECK_THAT(light(0.0f, 12.0), WithinRel(render::light_of_magnitude_zero, 1e-9)); // magnitudes are float
    CHECK_THAT(light(5.0f, 12.0), WithinRel(0.01 * render::light_of_magnitude_zero, 1e-9));
    CHECK_THAT(light(0.0f, 3.0), WithinRel(16.0 * render::light_of_magnitude_zero, 1e-9));
}

TEST_CASE("a moving eye sees the flux of a black body at T/D, D^2 of it by aberration") {
    const render::DopplerColour colour(5762.0);
    const render::Observer observer;
    const auto source = render::star_source(colour, star_of(1.0f, 9600.0f, 25.0));
    const auto light = [&](render::Mode mode, double ratio) {
        return luminance(colour, render::star_light(colour, source, mode, 25.0, ratio));
    };
    const double at_rest = light(render::Mode::full, 1.0);
    for (const double ratio : {0.1, 0.7, 1.6, 4.0}) {
        const double shift = std::exp(observer.black_body(9600.0 / ratio).ln_y - observer.black_body(9600.0).ln_y);
        // 1e-5: the black body table's interpolation.
        CHECK_THAT(light(render::Mode::full, ratio), WithinRel(at_rest * ratio * ratio * shift, 1e-5));
        CHECK_THAT(light(render::Mode::searchlight, ratio), WithinRel(at_rest / (ratio * ratio), 1e-9));
        CHECK_THAT(light(render::Mode::geometry, ratio), WithinRel(at_rest * ratio * ratio, 1e-9));
    }
    // All modes agree where nothing moves.
    CHECK_THAT(light(render::Mode::doppler, 1.0), WithinRel(at_rest, 1e-12));
}

TEST_CASE("blackbody texels give a star's light as the shader computes it") {
    const render::DopplerColour colour(5762.0);
    const render::BlackBodyTexels table = render::black_body_texels(colour);
    const auto source = render::star_source(colour, star_of(3.0f, 3500.0f, 80.0));
    for (const double ratio : {0.02, 0.3, 1.0, 1.9}) {
        const double ln_seen = source.ln_temperature - std::log(ratio);
        const double position =
            render::BlackBodyTexels::samples *
                (static_cast<double>(table.coordinate_scale) * ln_seen + static_cast<double>(table.coordinate_offset)) -
            0.5;
        const auto left = static_cast<std::size_t>(position);
        const double t = position - static_cast<double>(left);
        const auto texel = [&](std::size_t component) {
            return (1.0 - t) * static_cast<double>(table.texels[4 * left + component]) +
                   t * static_cast<double>(table.texels[4 * left + 4 + component]);
        };
        const double strength = std::exp(source.ln_strength + texel(3) + 2.0 * std::log(ratio) - 2.0 * std::log(80.0));
        const glm::dvec3 expected = render::star_light(colour, source, render::Mode::full, 80.0, ratio);
        for (std::size_t i = 0; i < 3; ++i) {
            // Linear between steps of 1.1 % in T; the Wien term c2 / (560 nm T) is 14 at 1800 K.
            CHECK_THAT(strength * texel(i), WithinAbs(expected[static_cast<int>(i)], 1e-3 * glm::length(expected)));
        }
    }
}

TEST_CASE("a star's shares sum to one wherever it lies between pixels") {
    for (float dx = -0.5f; dx <= 0.5f; dx += 0.0625f) {
        float sum = 0.0f;
        double square = 0.0;
        for (int y = -4; y <= 4; ++y) {
            for (int x = -4; x <= 4; ++x) {
                const float share =
                    star_shader::star_share({static_cast<float>(x) - dx, static_cast<float>(y) + 0.37f * dx});
                CHECK(share >= -1e-7f); // 243 - 6 * 32 + 15 in single precision
                sum += share;
                const double from_star = x - static_cast<double>(dx);
                square += static_cast<double>(share) * from_star * from_star;
            }
        }
        CHECK_THAT(sum, WithinAbs(1.0, 1e-5));    // 81 terms, each exact to 1e-7
        CHECK_THAT(square, WithinAbs(0.5, 1e-4)); // variance n/12 of a spline of order n = 6, whatever the offset
    }
}

TEST_CASE("a star is seen where a ray from the eye leads back to it") {
    for (const double rapidity : {0.0, 0.5493, 2.6467, 6.0}) {
        const glm::dvec3 along = glm::normalize(glm::dvec3(0.3, -0.2, -0.8));
        const auto world_from_head = sim::boost<sim::World, sim::Head>(sim::Rapidity(rapidity), along);
        for (int i = 0; i < 200; ++i) {
            const double height = -1.0 + (2.0 * i + 1.0) / 200.0;
            const double turn = 2.399963229728653 * i; // golden angle: even over the sphere
            const double radius = std::sqrt(1.0 - height * height);
            const glm::dvec3 seen(radius * std::cos(turn), height, radius * std::sin(turn));
            const sim::SeenLight light = sim::see(world_from_head, {seen});
            const glm::vec4 star = star_shader::star_seen(glm::vec3(17.0 * light.world_direction), glm::vec3(along),
                                                          static_cast<float>(std::exp(rapidity)));
            // Rounding the world direction to single precision (6e-8) is magnified by D, at most e^6 = 400.
            const double tolerance = 3e-7 * std::max(1.0, light.wavelength_ratio);
            CHECK(glm::length(glm::dvec3(star) - seen) < tolerance);
            CHECK_THAT(star.w, WithinRel(static_cast<float>(light.wavelength_ratio), 1e-5f));
        }
    }
}

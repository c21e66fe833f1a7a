#include "render/colour/colour_space.h"
#include "render/colour/display.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace shader {
using namespace glm;
#include "render/shaders/shared/display.glsl"
} // namespace shader

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

/// Oklab of XYZ with white D65, in double precision, by the published matrices (Ottosson 2020).
glm::dvec3 oklab(const glm::dvec3& xyz) {
    const glm::dmat3 cones_from_xyz(0.8189330101, 0.0329845436, 0.0482003018, 0.3618667424, 0.9293118715, 0.2643662691,
                                    -0.1288597137, 0.0361456387, 0.6338517070);
    const glm::dvec3 cones = cones_from_xyz * xyz;
    const glm::dvec3 roots(std::cbrt(cones.x), std::cbrt(cones.y), std::cbrt(cones.z));
    const glm::dmat3 lab_from_roots(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662,
                                    -0.0040720468, 0.4505937099, -0.8086757660);
    return lab_from_roots * roots;
}

glm::dvec3 oklab_of_srgb(const glm::vec3& rgb) {
    return oklab(glm::inverse(render::srgb_from_xyz()) * glm::dvec3(rgb));
}

double chroma(const glm::dvec3& lab) {
    return std::hypot(lab.y, lab.z);
}

/// Degrees between two hues.
double hue_difference(const glm::dvec3& a, const glm::dvec3& b) {
    const double turn = std::atan2(a.y * b.z - a.z * b.y, a.y * b.y + a.z * b.z);
    return std::abs(turn) * 180.0 / std::numbers::pi;
}

/// Colours that eyes see and sRGB has not: spectral lights desaturated a little, of all brightnesses.
std::vector<glm::vec3> vivid_colours() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    std::vector<glm::vec3> colours;
    while (colours.size() < 2000) {
        // Inside Rec. 2020, whose primaries are spectral colours.
        const glm::dvec3 wide(any(random), any(random), any(random));
        const glm::dvec3 rgb = glm::inverse(render::rgb_from_srgb(render::Primaries::rec2020)) * (wide * wide * wide);
        if (std::min({rgb.r, rgb.g, rgb.b}) < 0.0) {
            colours.emplace_back(std::exp2(12.0 * any(random) - 6.0) * rgb);
        }
    }
    return colours;
}

} // namespace

TEST_CASE("the gamut map keeps hue and luminance, and no more saturation than fits") {
    const shader::Gamut gamut = shader::srgb_gamut();
    double largest_turn = 0.0;
    for (const glm::vec3& colour : vivid_colours()) {
        const glm::vec3 inside = shader::within_gamut(colour, 1e30f, gamut);
        CAPTURE(colour.r, colour.g, colour.b);
        CHECK(std::min({inside.r, inside.g, inside.b}) >= 0.0f);
        // What lies within the slack counts as inside, and only loses what is below 0; all others keep luminance.
        const bool slack =
            std::min({colour.r, colour.g, colour.b}) >= -shader::gamut_slack * std::max({colour.r, colour.g, colour.b});
        const float wanted = shader::luminance(slack ? glm::max(colour, 0.0f) : colour);
        CHECK_THAT(shader::luminance(inside), WithinRel(wanted, 1e-5f)); // single precision
        const glm::dvec3 before = oklab_of_srgb(colour);
        const glm::dvec3 after = oklab_of_srgb(inside);
        if (chroma(after) > 0.01 * after.x) { // a grey has no hue
            largest_turn = std::max(largest_turn, hue_difference(before, after));
        }
        CHECK(chroma(after) / after.x <= chroma(before) / before.x + 1e-5);
        // As saturated as it can be: the least component is nearly 0 (the saturation is found to 3e-5).
        CHECK(std::min({inside.r, inside.g, inside.b}) <= 2e-3f * std::max({inside.r, inside.g, inside.b}));
    }
    // Half a degree is half of what eyes tell apart; single precision and the rounded matrices give a tenth.
    CHECK(largest_turn < 0.5);
}

TEST_CASE("the saturation that fits is found as bisection without end finds it") {
    const shader::Gamut gamut = shader::srgb_gamut();
    for (const float most : {shader::unlimited, 1.0f}) {
        std::vector<double> errors;
        for (const glm::vec3& colour : vivid_colours()) {
            const shader::HueLine line = shader::hue_line(colour, gamut);
            if (!shader::outside_gamut(colour, most) || line.luminance >= most) {
                continue;
            }
            shader::SaturationSearch search = shader::begin_search(line, most, gamut);
            for (float part = shader::first_part; part >= shader::last_part; part *= 0.5f) {
                search = shader::halved(search, part, line, most, gamut);
            }
            float exact = 0.0f;
            for (float part = 0.5f; part > 1e-6f; part *= 0.5f) {
                exact += shader::room_in_gamut(line, exact + part, most, gamut) >= 0.0f ? part : 0.0f;
            }
            errors.push_back(static_cast<double>(std::abs(shader::found_saturation(search) - exact)));
        }
        std::sort(errors.begin(), errors.end());
        REQUIRE(errors.size() > 800);
        CAPTURE(most);
        CHECK(errors[errors.size() * 99 / 100] < 3e-5); // a parabola's height over its chord of 1/256
        CHECK(errors.back() < 2e-3);                    // half of 1/256: another component takes over in between
    }
}

TEST_CASE("clipping each component instead would turn hues visibly") {
    double largest_turn = 0.0;
    for (const glm::vec3& colour : vivid_colours()) {
        largest_turn =
            std::max(largest_turn, hue_difference(oklab_of_srgb(colour), oklab_of_srgb(glm::max(colour, 0.0f))));
    }
    CHECK(largest_turn > 10.0); // so the test above can fail
}

TEST_CASE("what is brighter than a linear display keeps hue and luminance too, up to white") {
    const shader::Gamut gamut = shader::srgb_gamut();
    for (const glm::vec3& colour :
         {glm::vec3(1.8f, 0.3f, 0.1f), {0.1f, 0.2f, 3.0f}, {0.3f, 1.1f, 0.2f}, {1.5f, -0.1f, 0.4f}}) {
        const glm::vec3 shown = shader::within_gamut(colour, 1.0f, gamut);
        CAPTURE(colour.r, colour.g, colour.b);
        CHECK(std::max({shown.r, shown.g, shown.b}) <= 1.0f + 1e-6f);
        CHECK(std::min({shown.r, shown.g, shown.b}) >= 0.0f);
        CHECK_THAT(shader::luminance(shown), WithinRel(shader::luminance(colour), 1e-5f));
        CHECK(hue_difference(oklab_of_srgb(colour), oklab_of_srgb(shown)) < 0.5);
    }
    CHECK(shader::within_gamut({5.0f, 3.0f, 0.1f}, 1.0f, gamut) == glm::vec3(1.0f));
    CHECK(shader::within_gamut({-1.0f, 0.0f, 0.0f}, 1.0f, gamut) == glm::vec3(0.0f));
    CHECK(shader::within_gamut({0.2f, 0.0f, 0.9f}, 1.0f, gamut) == glm::vec3(0.2f, 0.0f, 0.9f)); // inside: untouched
}

TEST_CASE("Rec. 2020 has white where sRGB has it, its own primaries, and room for more colours") {
    const glm::dmat3 wide_from_srgb = render::rgb_from_srgb(render::Primaries::rec2020);
    const glm::dvec3 white = wide_from_srgb * glm::dvec3(1.0);
    // ITU-R BT.2087 table 2, four digits; its white is D65 to as many.
    const glm::dmat3 published(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.0880, 0.0433, 0.0114, 0.8956);
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(white[i], WithinAbs(1.0, 1e-12));
        for (int j = 0; j < 3; ++j) {
            CHECK_THAT(wide_from_srgb[i][j], WithinAbs(published[i][j], 1e-4));
        }
    }
    // A green that sRGB desaturates and Rec. 2020 shows as it is.
    const glm::dvec3 green(0.05, 0.6, 0.05);
    const glm::vec3 encoded = render::display_colour(glm::vec3(green), true, render::Primaries::rec2020);
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(render::linear_from_srgb(encoded[i]), WithinAbs(green[i], 1e-4)); // the transfer function's fit
    }
}

TEST_CASE("dithering shows the value itself in the mean, over every stretch of the picture") {
    for (const float value : {0.1f, 0.25f, 100.3f / 255.0f, 0.5f, 200.9f / 255.0f, 0.7f}) {
        for (const glm::ivec2& corner : {glm::ivec2(0, 0), glm::ivec2(517, 301), glm::ivec2(3000, 2000)}) {
            double sum = 0.0;
            constexpr int side = 32;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    sum += render::display_bytes(glm::vec3(value), corner + glm::ivec2(x, y), true)[1];
                }
            }
            // 1024 thresholds spread evenly err by a few of 1024; random ones would by 0.015.
            CHECK_THAT(sum / (side * side), WithinAbs(255.0 * static_cast<double>(value), 0.006));
        }
    }
    for (int byte = 0; byte < 256; ++byte) { // whole steps stay as they are
        const auto shown =
            render::display_bytes(glm::vec3((static_cast<float>(byte) + 1e-4f) / 255.0f), {byte, 7}, true);
        CHECK(shown[0] == byte);
    }
}

#include "render/colour/display.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace shared {
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::floatBitsToUint;
using glm::floor;
using glm::fract;
using glm::greaterThan;
using glm::mat3;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::vec2;
using glm::vec3;
namespace {
#include "render/shaders/shared/display.glsl"
#include "render/shaders/shared/false_colour.glsl"
} // namespace
} // namespace shared
namespace {

shared::Gamut make_gamut(Primaries primaries) {
    const shared::Gamut srgb = shared::srgb_gamut();
    const glm::dmat3 from_srgb = rgb_from_srgb(primaries);
    const glm::dmat3 xyz_from_rgb = glm::inverse(rgb_from_xyz(primaries));
    return {glm::mat3(glm::dmat3(srgb.cones_from_rgb) * glm::inverse(from_srgb)),
            glm::mat3(from_srgb * glm::dmat3(srgb.rgb_from_cones)),
            glm::vec3(xyz_from_rgb[0].y, xyz_from_rgb[1].y, xyz_from_rgb[2].y)};
}

const shared::Gamut& gamut_of(Primaries primaries) {
    static const shared::Gamut srgb = shared::srgb_gamut();
    static const shared::Gamut rec2020 = make_gamut(Primaries::rec2020);
    return primaries == Primaries::srgb ? srgb : rec2020;
}

} // namespace

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

std::uint8_t srgb_byte_from_linear(float linear) {
    return static_cast<std::uint8_t>(std::lround(255.0f * srgb_from_linear(linear)));
}

float luminance(const glm::vec3& rgb) {
    return shared::luminance(rgb);
}

glm::vec3 display_colour(const glm::vec3& exposed, bool linear_curve, Primaries primaries, float brightest) {
    return shared::display_colour(exposed, !linear_curve, brightest, gamut_of(primaries));
}

std::array<std::uint8_t, 3> display_bytes(const glm::vec3& encoded, const glm::ivec2& pixel, bool dither) {
    const glm::vec3 steps = shared::display_steps(encoded, dither ? shared::dither_threshold(glm::vec2(pixel)) : 0.5f);
    return {static_cast<std::uint8_t>(steps.r), static_cast<std::uint8_t>(steps.g), static_cast<std::uint8_t>(steps.b)};
}

glm::vec3 shift_colour(double log2_ratio, double range) {
    return shared::shift_colour(static_cast<float>(log2_ratio), static_cast<float>(range));
}

glm::vec3 brightness_colour(double share) {
    return shared::brightness_colour(static_cast<float>(share));
}

double band_middle(double level, double step) {
    return static_cast<double>(shared::band_middle(static_cast<float>(level), static_cast<float>(step)));
}

glm::vec3 with_iso_line(const glm::vec3& colour, double level, double step, double change, bool over_light) {
    const float line =
        shared::iso_line(static_cast<float>(level), static_cast<float>(step), static_cast<float>(change));
    return shared::with_line(colour, line, over_light);
}

} // namespace render

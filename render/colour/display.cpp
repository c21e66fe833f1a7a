#include "render/colour/display.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace shared {
using glm::clamp;
using glm::dot;
using glm::greaterThan;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::vec3;
namespace {
#include "render/shaders/shared/display.glsl"
}
} // namespace shared
namespace {

std::uint8_t byte_of(float encoded) {
    return static_cast<std::uint8_t>(std::lround(255.0f * encoded));
}

} // namespace

float srgb_from_linear(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
}

std::uint8_t srgb_byte_from_linear(float linear) {
    return byte_of(srgb_from_linear(linear));
}

float luminance(const glm::vec3& rgb) {
    return shared::luminance(rgb);
}

std::array<std::uint8_t, 3> display_bytes(const glm::vec3& exposed, bool linear_curve) {
    const glm::vec3 encoded = shared::display_colour(exposed, !linear_curve);
    return {byte_of(encoded.r), byte_of(encoded.g), byte_of(encoded.b)};
}

} // namespace render

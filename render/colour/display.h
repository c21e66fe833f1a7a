#pragma once

#include "content/srgb.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

/// From linear light to what a display is given, on the CPU: the mathematics is that of the display shader
/// (render/shaders/shared/display.glsl), so that a picture is the same whoever encodes it.
namespace render {

/// sRGB transfer function (IEC 61966-2-1): linear in [0, 1] to encoded in [0, 1]; clamps outside.
float srgb_from_linear(float linear);
/// Its inverse.
using content::linear_from_srgb;
/// Encoded and rounded to 8 bits.
std::uint8_t srgb_byte_from_linear(float linear);

/// Relative luminance of linear sRGB.
float luminance(const glm::vec3& rgb);

/// Exposed linear sRGB, of any gamut and brightness, as 8-bit sRGB: colours out of gamut lose saturation but keep hue
/// and luminance; then the filmic curve (or, linear, what is above 1 is clipped).
std::array<std::uint8_t, 3> display_bytes(const glm::vec3& exposed, bool linear_curve);

} // namespace render

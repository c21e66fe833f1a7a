#pragma once

#include <cstdint>

namespace render {

/// sRGB transfer function (IEC 61966-2-1): linear in [0, 1] to encoded in [0, 1]; clamps outside.
float srgb_from_linear(float linear);
/// Its inverse.
float linear_from_srgb(float encoded);
/// Encoded and rounded to 8 bits.
std::uint8_t srgb_byte_from_linear(float linear);

} // namespace render

#pragma once

#include "content/srgb.h"
#include "render/colour/colour_space.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

/// From linear light to what a display is given, on the CPU: the mathematics is that of the display shader
/// (render/shaders/shared/display.glsl, false_colour.glsl), so that a picture is the same whoever encodes
/// it.
namespace render {

/// sRGB transfer function (IEC 61966-2-1): linear in [0, 1] to encoded in [0, 1]; clamps outside.
float srgb_from_linear(float linear);
/// Its inverse.
using content::linear_from_srgb;
/// Encoded and rounded to 8 bits.
std::uint8_t srgb_byte_from_linear(float linear);

/// Relative luminance of linear sRGB.
float luminance(const glm::vec3& rgb);

/// Exposed linear RGB of these primaries, of any gamut and brightness, encoded by sRGB's transfer function. Colours out
/// of gamut lose saturation but keep their hue (in Oklab) and luminance; then the filmic curve. Without it (linear)
/// the same happens to what is brighter than the display, up to white. `brightest`: see Display.
glm::vec3 display_colour(const glm::vec3& exposed, bool linear_curve, Primaries primaries = Primaries::srgb,
                         float brightest = 1.0f);

/// As 8 bits. `pixel`, from the picture's lower left corner, decides which way fractions of a step go.
std::array<std::uint8_t, 3> display_bytes(const glm::vec3& encoded, const glm::ivec2& pixel, bool dither);

/// False colours, encoded sRGB. D: log2 D in [-range, range]; luminance: in [0, 1] from the darkest shown to the
/// brightest.
glm::vec3 shift_colour(double log2_ratio, double range);
glm::vec3 brightness_colour(double share);
/// Middle of the band between two iso-lines, whole multiples of `step`, that a level lies in.
double band_middle(double level, double step);
/// A colour with an iso-line over it: `change` is the length of the level's gradient, per pixel.
glm::vec3 with_iso_line(const glm::vec3& colour, double level, double step, double change, bool over_light);

} // namespace render

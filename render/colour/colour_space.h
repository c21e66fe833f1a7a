#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

/// Linear RGB of displays and CIE XYZ, double precision.
namespace render {

/// The primaries of an RGB space; white is D65.
enum class Primaries : std::uint8_t {
    srgb,    ///< ITU-R BT.709: what everything in Rapidity is computed in
    rec2020, ///< ITU-R BT.2020: wide gamut, for output
};

/// CIE 1931 x, y.
struct Chromaticities {
    glm::dvec2 red{0.0};
    glm::dvec2 green{0.0};
    glm::dvec2 blue{0.0};
};

Chromaticities chromaticities(Primaries primaries);

/// XYZ of D65 with Y = 1 (ASTM E308, 2-degree observer): the display's white.
inline constexpr glm::dvec3 d65_xyz{0.95047, 1.0, 1.08883};

/// Linear RGB from XYZ: D65 gives (1, 1, 1).
glm::dmat3 rgb_from_xyz(Primaries primaries);
/// The same for sRGB.
glm::dmat3 srgb_from_xyz();

/// Linear RGB of these primaries from linear sRGB: the same colour.
glm::dmat3 rgb_from_srgb(Primaries primaries);

/// Linear Bradford adaptation: takes `from_white` (XYZ) to `to_white` and every other colour along with it.
glm::dmat3 bradford_adaptation(const glm::dvec3& from_white, const glm::dvec3& to_white);

} // namespace render

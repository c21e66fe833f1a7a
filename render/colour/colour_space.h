#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

/// Linear sRGB (BT.709 primaries, white D65) and CIE XYZ, double precision.
namespace render {

/// XYZ of D65 with Y = 1 (ASTM E308, 2-degree observer): the display's white.
inline constexpr glm::dvec3 d65_xyz{0.95047, 1.0, 1.08883};

/// Linear sRGB from XYZ: D65 gives (1, 1, 1).
glm::dmat3 srgb_from_xyz();

/// Linear Bradford adaptation: takes `from_white` (XYZ) to `to_white` and every other colour along with it.
glm::dmat3 bradford_adaptation(const glm::dvec3& from_white, const glm::dvec3& to_white);

} // namespace render

#pragma once

#include <glm/vec3.hpp>

namespace render {

/// Reflectance of the generated planet in the unit direction from its centre (its own axes, +z north): seas, land that
/// goes from forest to desert and rock, ice towards the poles, clouds above. Linear sRGB; the same every time.
glm::dvec3 planet_reflectance(const glm::dvec3& direction);

} // namespace render

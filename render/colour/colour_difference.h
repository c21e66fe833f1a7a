#pragma once

#include <glm/vec3.hpp>

namespace render {

/// CIE L*a*b* of XYZ relative to a D65 white with Y = 1. Light without luminance is L* = 0; brighter than white is
/// above 100.
glm::dvec3 lab_from_xyz(const glm::dvec3& xyz);

/// CIEDE2000 colour difference of two L*a*b* colours (ISO/CIE 11664-6, all weights 1). About 1 is just seen.
double ciede2000(const glm::dvec3& lab_1, const glm::dvec3& lab_2);

} // namespace render

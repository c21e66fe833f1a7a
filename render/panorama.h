#pragma once

#include "content/scene_desc.h"

namespace render {

/// Radiance of a panorama in a unit world direction: bilinear between texels, across the seam and up to the poles.
glm::dvec3 panorama_radiance(const content::Panorama& panorama, const glm::dvec3& direction);

} // namespace render

#pragma once

#include "content/scene_desc.h"

#include <glm/vec3.hpp>

#include <vector>

namespace render {

/// A panorama at halved resolutions, to be averaged over what a ray stands for: where gravity squeezes a whole sky into
/// a pixel, single texels would sparkle.
class PanoramaPyramid {
  public:
    explicit PanoramaPyramid(content::Panorama panorama);

    /// Mean radiance around the unit `direction` over the parallelogram of the two tangent vectors (radians; its full
    /// sides): trilinear along the shorter axis, up to 16 taps along the longer. Shorter still, the shorter axis is
    /// taken as a 16th of the longer.
    glm::dvec3 radiance(const glm::dvec3& direction, const glm::dvec3& side_u, const glm::dvec3& side_v) const;

  private:
    glm::dvec3 at_level(const glm::dvec3& direction, double level) const;

    std::vector<content::Panorama> levels_;
};

} // namespace render

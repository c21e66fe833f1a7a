#pragma once

#include "content/scene_desc.h"
#include "render/offline/scenery_hits.h"

namespace render {

/// Radiance that leaves a surface towards the eye as seen at rest in the world, linear sRGB:
///   L = reflectance (E_sun/pi max(0, n.s) visible + ambient (0.65 + 0.35 n.y) + sum_lamps I/pi max(0, n.l) w(d)/d^2)
///       + emission,   w(d) = clamp(1 - (d/range)^4, 0, 1), d at least 0.05 m;   unlit: L = base colour.
/// The sun's shadows are traced; lamps cast none.
glm::dvec3 surface_radiance(const content::SceneDesc& scene, const SceneryHits& scenery, const SurfaceHit& hit);

/// Radiance of the sky seen in the unit world direction: the panorama, bilinear, or the gradient.
glm::dvec3 sky_radiance(const content::SceneDesc& scene, const glm::dvec3& direction);

} // namespace render

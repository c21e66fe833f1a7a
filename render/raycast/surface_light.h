#pragma once

#include "content/scene_desc.h"
#include "render/offline/scenery_hits.h"
#include "render/raycast/cast_scenery.h"
#include "render/raycast/lanes.h"
#include "render/raycast/texture_pool.h"

#include <glm/vec3.hpp>

#include <vector>

namespace render {

/// Where a packet's rays come from and go to, world frame, scene metres.
struct PacketRays {
    glm::vec3 origin{0.0f};
    Lanes3 direction; ///< unit
    Lanes spread;     ///< how much wider a pixel's cone gets a metre
};

/// Light that leaves surfaces at rest, as rest_light.h says, sixteen hits at a time in single precision. Textures are
/// filtered over what a pixel covers of the surface.
class SurfaceLight {
  public:
    /// Keeps references: both must outlive this.
    SurfaceLight(const content::SceneDesc& scene, const SceneryHits& scenery);

    /// Radiance of the `wanted` hits, linear RGB; the other lanes' values mean nothing.
    void radiance(const PacketRays& rays, const PacketHits& hits, LaneMask wanted, Lanes3& light) const;

  private:
    const content::SceneDesc& scene_;
    const SceneryHits& scenery_;
    CastScenery surfaces_;
    TexturePool textures_;
    glm::vec3 towards_sun_{0.0f, 1.0f, 0.0f};
    glm::vec3 sun_light_{0.0f}; ///< irradiance / pi; 0 without a sun
};

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/offline/scenery_hits.h"
#include "render/raycast/cast_scenery.h"
#include "render/raycast/lanes.h"
#include "render/raycast/packet_terms.h"
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

struct Surfaces;

/// Light of surfaces, as rest_light.h says, as the moving eye sees it, sixteen hits at a time in single precision.
/// Textures are filtered over what a pixel covers of the surface.
class SurfaceLight {
  public:
    /// Keeps references: all must outlive this.
    SurfaceLight(const content::SceneDesc& scene, const SceneSpectra& spectra, const SceneryHits& scenery);

    /// Adds the light seen of the `wanted` hits to their lanes, linear RGB.
    void add_seen_light(const PacketRays& rays, const PacketHits& hits, LaneMask wanted, const PacketColours& colours,
                        Lanes3& light) const;

  private:
    struct Received;
    void receive(const Surfaces& surfaces, const PacketHits& hits, LaneMask lit, Received& received) const;
    void add_reflected(const Surfaces& surfaces, const Received& received, LaneMask lit, const PacketColours& colours,
                       Lanes3& light) const;
    /// What surfaces of a material send on of falling light `of_light`.
    void add_terms(const Surfaces& surfaces, const CastMaterial& material, LaneMask lanes, int of_light,
                   const LitLanes& lit, const PacketColours& colours, Lanes3& light) const;
    void add_emitted(const Surfaces& surfaces, LaneMask wanted, const PacketColours& colours, Lanes3& light) const;

    const content::SceneDesc& scene_;
    const SceneSpectra& spectra_;
    const SceneryHits& scenery_;
    CastScenery surfaces_;
    TexturePool textures_;
    glm::vec3 towards_sun_{0.0f, 1.0f, 0.0f};
    glm::vec3 sun_light_{0.0f}; ///< irradiance / pi; 0 without a sun
};

} // namespace render

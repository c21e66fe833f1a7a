#pragma once

#include "content/scene_desc.h"
#include "render/colour/scene_colour.h"
#include "render/raycast/light_packets.h"
#include "render/render_frame.h"
#include "render/stereo_share.h"

#include <glm/vec4.hpp>

#include <memory>
#include <span>

namespace render {

/// The ray method: casts rays through the warped view into the world at rest, in packets of sixteen on all processors,
/// and shades what they meet. Edges are exact and the cost hardly depends on the velocity; needs no OpenGL. Single
/// precision: behind the eye at rapidity xi what is seen is placed within about 1e-7 e^xi radians.
class RayCaster {
  public:
    /// Keeps references: both must outlive this. Throws sim::BadInput for a scene that Embree cannot hold.
    RayCaster(const content::SceneDesc& scene, const SceneColour& colour);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) = delete;

    /// Light without stars times `pre_exposure`, linear RGB; w: how much of the sky is to be seen. width x height
    /// pixels, rows from the top.
    void light(const RenderFrame& frame, double pre_exposure, std::span<glm::vec4> pixels) const;
    /// The same in packets, which are resized.
    /// `share`: of both eyes of a headset; may be null. `depths`: none, or one a pixel, rows from the bottom:
    /// nearest_depth / z, z metres ahead of the eye, for an eye at rest; 0 for the sky.
    void light(const RenderFrame& frame, double pre_exposure, LightPackets& packets, StereoShare* share = nullptr,
               std::span<float> depths = {}) const;
    /// Adds the stars' light to what light() has cast of the same frame with the same `pre_exposure`.
    void add_stars(const RenderFrame& frame, double pre_exposure, LightPackets& packets,
                   StereoShare* share = nullptr) const;

    /// A finished picture. Light as radiance, with stars, the mean over samples_per_side^2 rays on a regular grid in
    /// each pixel; other layers by the ray through the pixel's centre.
    Picture picture(const RenderFrame& frame, int samples_per_side = 1) const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace render

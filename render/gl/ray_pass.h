#pragma once

#include "render/colour/auto_exposure.h"
#include "render/gl/byte_picture.h"
#include "render/gl/render_target.h"
#include "render/raycast/ray_caster.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace render {

/// Pictures of the ray method: cast, metered and, where they are shown as light, encoded on the processor; OpenGL then
/// only puts their bytes on the screen. False colours are left to the display pass.
class RayPass {
  public:
    /// Takes the scene over; keeps a reference to `colour`, which must outlive this.
    RayPass(content::SceneDesc scene, const SceneColour& colour);

    /// Casts a frame's light times `pre_exposure`, without stars. Keeps depths for copying if asked to.
    void cast(const RenderFrame& frame, double pre_exposure, StereoShare* share, bool keep_depth);
    void add_stars(const RenderFrame& frame, double pre_exposure, StereoShare* share);

    /// How bright what has been cast is, before any exposure.
    MeteredLight metered(double pre_exposure) const;
    /// What has been cast, times `factor`.
    Picture picture(float factor) const;
    /// A picture of a layer besides light.
    Picture layer(const RenderFrame& frame) const { return caster_.picture(frame); }

    /// Whether show() can show pictures like that.
    static bool shows(const Display& display);
    /// Shows what has been cast: factor is on top of the pre-exposure. Scaled to the viewport if sizes differ.
    void show(const RenderFrame& frame, double factor, unsigned target_framebuffer, const Viewport& viewport);

    /// Puts what has been cast into a target of its size, for the display pass.
    void load(const RenderTarget& target);

    /// Copies the depths that the last cast kept into the lower left corner of a texture, see nearest_depth.
    void copy_depth(GLuint texture) const;

  private:
    std::unique_ptr<const content::SceneDesc> scene_; ///< stays where it is
    RayCaster caster_;
    LightPackets packets_;
    LightPackets with_glare_;
    std::vector<float> depths_;
    std::vector<HalfPixel> halves_;
    PacketDisplay display_;
    BytePicture on_screen_;
};

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/gl/gl_objects.h"

namespace render {

/// A panorama as a mipmapped cube map in OpenGL, half floats, at the panorama's own sharpness: faces of 2/pi of its
/// height, 64 bytes a texel of them (24 MiB for a panorama of 2048 x 1024, 95 MiB for one of 4096 x 2048).
/// Cube axes are the world's: sampled with a world direction.
class SkyCube {
  public:
    explicit SkyCube(const content::Panorama& panorama);

    GLuint texture() const { return texture_.name(); }

    /// For sky_lod in shared/sky_lod.glsl: texels across a pixel at the centre of a screen with `focal_pixels` pixels a
    /// unit tangent, where D = 1.
    float texels_per_pixel(double focal_pixels) const { return static_cast<float>(0.5 * size_ / focal_pixels); }

  private:
    int size_;
    Texture texture_;
};

} // namespace render

#pragma once

#include "render/gl/render_target.h"
#include "render/gl/renderer.h"

#include <cstdint>
#include <span>

namespace render {

/// Puts finished pictures, made on the processor, on the screen.
class BytePicture {
  public:
    /// Bytes red, green, blue, 255, rows from the bottom, `size` of them; encoded already, so they are only copied, and
    /// scaled to the viewport linearly if the sizes differ.
    void show(std::span<const std::uint32_t> rgba, const glm::ivec2& size, unsigned target_framebuffer,
              const Viewport& viewport);

  private:
    RenderTarget picture_{GL_RGBA8, GL_LINEAR, false};
};

} // namespace render

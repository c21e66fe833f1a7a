#pragma once

#include "render/gl/render_target.h"
#include "render/gl/renderer.h"
#include "render/raycast/packet_display.h"

#include <cstdint>
#include <span>

namespace render {

/// Puts finished pictures, made on the processor, on the screen.
class BytePicture {
  public:
    /// The layout in which a picture needs only to be copied: windows of Mesa's software OpenGL begin at the top with
    /// blue, other targets (RGBA8) at the bottom with red. Any other is converted, pixel by pixel.
    static ByteLayout layout_for(unsigned target_framebuffer);

    /// `bytes`: as many as the viewport has pixels, encoded already.
    void show(std::span<const std::uint32_t> bytes, const ByteLayout& layout, unsigned target_framebuffer,
              const Viewport& viewport);

  private:
    void resize_blue_first(const glm::ivec2& size);

    RenderTarget red_first_{GL_RGBA8, GL_NEAREST, false};
    Texture blue_first_;
    Framebuffer of_blue_first_;
    glm::ivec2 blue_first_size_{0};
};

} // namespace render

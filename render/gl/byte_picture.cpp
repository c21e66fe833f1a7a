#include "render/gl/byte_picture.h"

namespace render {

void BytePicture::show(std::span<const std::uint32_t> rgba, const glm::ivec2& size, unsigned target_framebuffer,
                       const Viewport& viewport) {
    picture_.resize(size);
    glTextureSubImage2D(picture_.colour(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    const bool same_size = viewport.width == size.x && viewport.height == size.y;
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(picture_.framebuffer(), target_framebuffer, 0, 0, size.x, size.y, viewport.x, viewport.y,
                           viewport.x + viewport.width, viewport.y + viewport.height, GL_COLOR_BUFFER_BIT,
                           same_size ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer); // as the display pass leaves it
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
}

} // namespace render

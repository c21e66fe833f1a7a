#include "render/gl/byte_picture.h"

namespace render {

ByteLayout BytePicture::layout_for(unsigned target_framebuffer) {
    const bool window = target_framebuffer == 0;
    return {window, window};
}

void BytePicture::resize_blue_first(const glm::ivec2& size) {
    if (size == blue_first_size_) {
        return;
    }
    blue_first_size_ = size;
    of_blue_first_ = Framebuffer::create();
    blue_first_ = Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureParameteri(blue_first_.name(), GL_TEXTURE_MAX_LEVEL, 0);
    // Storage of a sized format would begin with red; of this one Mesa takes the order of what it is first given.
    glBindTexture(GL_TEXTURE_2D, blue_first_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size.x, size.y, 0, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, nullptr);
    glBindTexture(GL_TEXTURE_2D, 0);
    glNamedFramebufferTexture(of_blue_first_.name(), GL_COLOR_ATTACHMENT0, blue_first_.name(), 0);
}

void BytePicture::show(std::span<const std::uint32_t> bytes, const ByteLayout& layout, unsigned target_framebuffer,
                       const Viewport& viewport) {
    const glm::ivec2 size(viewport.width, viewport.height);
    if (layout.blue_first) {
        resize_blue_first(size);
    } else {
        red_first_.resize(size);
    }
    glTextureSubImage2D(layout.blue_first ? blue_first_.name() : red_first_.colour(), 0, 0, 0, size.x, size.y,
                        layout.blue_first ? GL_BGRA : GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, bytes.data());
    glDisable(GL_FRAMEBUFFER_SRGB);
    // From the top means upside down for OpenGL: turned over on the way.
    glBlitNamedFramebuffer(layout.blue_first ? of_blue_first_.name() : red_first_.framebuffer(), target_framebuffer, 0,
                           layout.from_top ? size.y : 0, size.x, layout.from_top ? 0 : size.y, viewport.x, viewport.y,
                           viewport.x + size.x, viewport.y + size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer); // as the display pass leaves it
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
}

} // namespace render

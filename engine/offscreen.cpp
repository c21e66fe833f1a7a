#include "engine/offscreen.h"

#include <algorithm>

namespace engine {

Offscreen::Offscreen(int width, int height)
    : width_(width), height_(height), colour_(render::Texture::create(GL_TEXTURE_2D)),
      framebuffer_(render::Framebuffer::create()) {
    glTextureStorage2D(colour_.name(), 1, GL_RGBA8, width, height);
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
}

void Offscreen::write(const content::Image& picture) {
    const auto row = static_cast<std::size_t>(width_) * 4;
    for (int y = 0; y < height_; ++y) {
        glTextureSubImage2D(colour_.name(), 0, 0, height_ - 1 - y, width_, 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            &picture.rgba[static_cast<std::size_t>(y) * row]);
    }
}

content::Image Offscreen::read() const {
    return read_pixels(framebuffer_.name(), width_, height_);
}

content::Image read_pixels(GLuint framebuffer, int width, int height) {
    content::Image image;
    image.width = width;
    image.height = height;
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    image.rgba.resize(row * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    // OpenGL's first row is the lowest.
    for (std::size_t top = 0, bottom = static_cast<std::size_t>(height) - 1; top < bottom; ++top, --bottom) {
        std::swap_ranges(image.rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                         image.rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                         image.rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
    }
    for (std::size_t alpha = 3; alpha < image.rgba.size(); alpha += 4) {
        image.rgba[alpha] = 255;
    }
    return image;
}

} // namespace engine

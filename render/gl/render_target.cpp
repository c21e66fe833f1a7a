#include "render/gl/render_target.h"

#include <glm/common.hpp>

namespace render {

void RenderTarget::grow(const glm::ivec2& least) {
    // In steps, so that a view that turns does not reallocate every frame.
    constexpr int step = 128;
    resize(glm::max(size_, (least + (step - 1)) / step * step));
}

void RenderTarget::resize(const glm::ivec2& size) {
    if (size == size_) {
        return;
    }
    size_ = size;
    framebuffer_ = Framebuffer::create();
    colour_ = Texture::create(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(colour_.name(), 1, colour_format_, size.x, size.y);
    glTextureParameteri(colour_.name(), GL_TEXTURE_MIN_FILTER, filter_);
    glTextureParameteri(colour_.name(), GL_TEXTURE_MAG_FILTER, filter_);
    glTextureParameteri(colour_.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(colour_.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    if (with_depth_) {
        depth_ = Texture::create(GLenum{GL_TEXTURE_2D});
        glTextureStorage2D(depth_.name(), 1, GL_DEPTH_COMPONENT32F, size.x, size.y);
        glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    }
}

} // namespace render

#pragma once

#include "render/gl/gl_objects.h"

#include <glm/vec2.hpp>

namespace render {

/// A colour texture, with a float depth buffer if wanted, to draw into.
class RenderTarget {
  public:
    RenderTarget(GLenum colour_format, GLint filter, bool with_depth)
        : colour_format_(colour_format), filter_(filter), with_depth_(with_depth) {}

    /// Makes both sides at least as long as asked; contents are lost when it has to grow.
    void grow(const glm::ivec2& least);
    /// Makes it exactly that size; contents are lost when that changes it.
    void resize(const glm::ivec2& size);

    const glm::ivec2& size() const { return size_; }
    GLuint depth() const { return depth_.name(); }
    GLuint colour() const { return colour_.name(); }
    GLuint framebuffer() const { return framebuffer_.name(); }

  private:
    GLenum colour_format_;
    GLint filter_;
    bool with_depth_;
    glm::ivec2 size_{0};
    Texture colour_;
    Texture depth_;
    Framebuffer framebuffer_;
};

} // namespace render

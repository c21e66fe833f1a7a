#pragma once

#include "render/colour/bloom.h"
#include "render/gl/gl_objects.h"

#include <vector>

namespace render {

/// The bloom's pyramid in OpenGL: what `bloomed` does, on a picture in a texture.
class BloomPass {
  public:
    BloomPass();

    /// Scatters a 2D texture's light, width x height pixels; returns the texture of the finest cells, which the display
    /// pass mixes in (linear filter, clamped), 0 where the picture is too small. Leaves its own framebuffer bound.
    GLuint scatter(GLuint light, const glm::ivec2& size);

  private:
    void resize(const glm::ivec2& size);
    void draw_level(const Program& program, GLuint source, std::size_t target) const;

    Program finest_;
    Program level_;
    VertexArray no_attributes_;
    glm::ivec2 size_{0};
    BloomGrid grid_{glm::ivec2(0)};
    std::vector<Texture> cells_;
    std::vector<Framebuffer> framebuffers_;
};

} // namespace render

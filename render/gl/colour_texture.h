#pragma once

#include "render/colour/frame_colour_table.h"
#include "render/gl/gl_objects.h"

#include <glm/vec2.hpp>

namespace render {

/// The frame's colour table on the GPU.
class ColourTexture {
  public:
    explicit ColourTexture(const SceneSpectra& spectra);

    void upload(const FrameColourTable& table);

    GLuint name() const { return texture_.name(); }
    /// On log2 D, for the texture coordinate.
    const glm::vec2& scale_and_offset() const { return scale_and_offset_; }

  private:
    Texture texture_;
    glm::vec2 scale_and_offset_{0.0f};
};

} // namespace render

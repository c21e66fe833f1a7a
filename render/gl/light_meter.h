#pragma once

#include "render/gl/gl_objects.h"

#include <vector>

namespace render {

/// Reads how bright a rendered picture is: the mean luminance of each square of 8 x 8 pixels.
class LightMeter {
  public:
    LightMeter();

    /// Of a 2D texture of linear RGB; waits for it to be rendered. Whole squares only, at least one; rows from the
    /// bottom. Leaves its own framebuffer bound.
    std::vector<float> luminances(GLuint texture, int width, int height);

  private:
    void resize(int columns, int rows);

    Program program_;
    VertexArray no_attributes_;
    Sampler sampler_;
    Texture squares_;
    Framebuffer framebuffer_;
    int columns_ = 0;
    int rows_ = 0;
};

} // namespace render

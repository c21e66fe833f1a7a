#pragma once

#include "render/colour/auto_exposure.h"
#include "render/gl/gl_objects.h"

namespace render {

/// Reads how bright a rendered picture is, in squares of 8 x 8 pixels; their brightest spots are 2 x 2.
class LightMeter {
  public:
    LightMeter();

    /// Of a 2D texture that holds linear RGB times pre_exposure; waits for it to be rendered. Whole squares only, at
    /// least one. Leaves its own framebuffer bound.
    MeteredLight meter(GLuint texture, int width, int height, double pre_exposure);

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

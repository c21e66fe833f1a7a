#pragma once

#include "render/colour/auto_exposure.h"
#include "render/gl/light_meter.h"
#include "render/gl/renderer.h"

namespace render {

/// From rendered linear light to the picture that is shown: exposure, tone curve, sRGB. The light is rendered with a
/// pre-exposure close to the final one, so that half floats hold it; what remains is done here.
class DisplayPass {
  public:
    DisplayPass();

    /// Factor to render the next frame's light with. `luminance_ahead`: of a white surface where the eye looks, a guess
    /// for the first automatic exposure.
    double pre_exposure(const Exposure& exposure, double luminance_ahead) const;

    /// The whole factor on radiance for this frame, given its light (2D texture, times pre_exposure, width x height).
    /// Automatic exposure reads the light back; a manual one does not touch OpenGL.
    double factor(const RenderFrame& frame, GLuint light, double pre_exposure);

    /// Shows the light: factor = factor() / pre_exposure. Scales it to the viewport if the sizes differ.
    void draw(const RenderFrame& frame, GLuint light, double factor, unsigned target_framebuffer,
              const Viewport& viewport) const;

  private:
    Program program_;
    VertexArray no_attributes_;
    Sampler nearest_;
    Sampler smooth_;
    LightMeter meter_;
    AutoExposure automatic_;
};

} // namespace render

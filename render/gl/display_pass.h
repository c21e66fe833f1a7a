#pragma once

#include "render/colour/auto_exposure.h"
#include "render/gl/bloom_pass.h"
#include "render/gl/light_meter.h"
#include "render/gl/renderer.h"

#include <array>
#include <vector>

namespace render {

/// From rendered linear light to the picture that is shown: bloom, exposure, tone curve, sRGB, 8 bits; or its false
/// colours. The light is rendered with a pre-exposure close to the final one, so that half floats hold it; what remains
/// is done here.
class DisplayPass {
  public:
    DisplayPass();

    /// Factor to render the next frame's light with. `luminance_ahead`: of a white surface where the eye looks, a guess
    /// for the pane's first automatic exposure.
    double pre_exposure(const RenderFrame& frame, double luminance_ahead) const;

    /// The whole factor on radiance for this frame, given its light (2D texture, times pre_exposure, width x height).
    /// Automatic exposure reads the light back; a manual one does not touch OpenGL.
    double factor(const RenderFrame& frame, GLuint light, double pre_exposure);
    /// The same, given how bright its light is before any exposure; not looked at by a manual one.
    double factor(const RenderFrame& frame, MeteredLight metered);

    /// Shows the light: factor = factor() / pre_exposure. Scales it to the viewport if the sizes differ.
    void draw(const RenderFrame& frame, GLuint light, double factor, unsigned target_framebuffer,
              const Viewport& viewport);

  private:
    const Program& program(bool bloom, bool analysis);
    void set_analysis(const Program& program, const RenderFrame& frame, const Viewport& viewport) const;

    std::array<Program, 4> programs_; ///< made when first wanted; by bloom + 2 analysis
    VertexArray no_attributes_;
    Sampler nearest_;
    Sampler smooth_;
    LightMeter meter_;
    BloomPass bloom_;
    std::vector<AutoExposure> automatic_; ///< by pane
};

} // namespace render

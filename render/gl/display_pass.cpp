#include "render/gl/display_pass.h"

#include "render/gl/shader_library.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

Sampler make_sampler(GLint filter) {
    Sampler sampler = Sampler::create();
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MIN_FILTER, filter);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_MAG_FILTER, filter);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(sampler.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return sampler;
}

double in_automatic_range(double factor) {
    return std::clamp(factor, std::exp2(AutoExposure::darkest_stops), std::exp2(AutoExposure::brightest_stops));
}

} // namespace

DisplayPass::DisplayPass()
    : program_(make_program("fullscreen.vert", "display.frag")), no_attributes_(VertexArray::create()),
      nearest_(make_sampler(GL_NEAREST)), smooth_(make_sampler(GL_LINEAR)) {}

double DisplayPass::pre_exposure(const Exposure& exposure, double luminance_ahead) const {
    const auto stops = static_cast<double>(exposure.stops);
    if (!exposure.automatic) {
        return std::exp2(stops);
    }
    return automatic_.current(in_automatic_range(0.25 / std::max(luminance_ahead, 1e-30))) * std::exp2(stops);
}

double DisplayPass::factor(const RenderFrame& frame, GLuint light, double pre_exposure) {
    const auto stops = static_cast<double>(frame.exposure.stops);
    if (!frame.exposure.automatic) {
        return std::exp2(stops);
    }
    return automatic_.adapt(meter_.meter(light, frame.eye.width, frame.eye.height, pre_exposure),
                            frame.seconds_since_last_frame, stops);
}

void DisplayPass::draw(const RenderFrame& frame, GLuint light, double factor, unsigned target_framebuffer,
                       const Viewport& viewport) const {
    const bool same_size = viewport.width == frame.eye.width && viewport.height == frame.eye.height;
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB); // the shader encodes
    glProgramUniform1f(program_.name(), 0, static_cast<float>(factor));
    glProgramUniform1i(program_.name(), 1, frame.exposure.linear_curve ? 0 : 1);
    glUseProgram(program_.name());
    glBindVertexArray(no_attributes_.name());
    glBindTextureUnit(0, light);
    glBindSampler(0, same_size ? nearest_.name() : smooth_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
}

} // namespace render

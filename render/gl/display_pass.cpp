#include "render/gl/display_pass.h"

#include "render/colour/false_colour_scale.h"
#include "render/gl/boosted_view.h"
#include "render/gl/shader_library.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace render {
namespace {

enum Location : GLint {
    exposure = 0,
    filmic_curve = 1,
    corner = 2,
    dither = 3,
    bloom_share = 4,
    picture_size = 5,
    ray_origin = 6,
    ray_across = 7,
    ray_upwards = 8,
    exp_rapidity = 9,
    shown_view = 10,
    iso_lines = 11,
    scale_of_shift = 12,
    scale_of_brightness = 13,
    shown_pixel = 14,
    brightest = 15,
};

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
    : no_attributes_(VertexArray::create()), nearest_(make_sampler(GL_NEAREST)), smooth_(make_sampler(GL_LINEAR)) {}

double DisplayPass::pre_exposure(const RenderFrame& frame, double luminance_ahead) const {
    const auto stops = static_cast<double>(frame.exposure.stops);
    if (!frame.exposure.automatic) {
        return std::exp2(stops);
    }
    const AutoExposure& automatic = frame.pane < automatic_.size() ? automatic_[frame.pane] : AutoExposure();
    return automatic.current(in_automatic_range(0.25 / std::max(luminance_ahead, 1e-30))) * std::exp2(stops);
}

double DisplayPass::factor(const RenderFrame& frame, GLuint light, double pre_exposure) {
    return factor(frame, frame.exposure.automatic ? meter_.meter(light, frame.eye.width, frame.eye.height, pre_exposure)
                                                  : MeteredLight{});
}

double DisplayPass::factor(const RenderFrame& frame, MeteredLight metered) {
    const auto stops = static_cast<double>(frame.exposure.stops);
    if (!frame.exposure.automatic) {
        return std::exp2(stops);
    }
    automatic_.resize(std::max(automatic_.size(), frame.pane + 1));
    return automatic_[frame.pane].adapt(std::move(metered), frame.seconds_since_last_frame, stops);
}

const Program& DisplayPass::program(bool bloom, bool analysis) {
    Program& wanted = programs_[(bloom ? 1u : 0u) + (analysis ? 2u : 0u)];
    if (!wanted) {
        const std::string defines =
            std::string(bloom ? "#define BLOOM\n" : "") + (analysis ? "#define ANALYSIS\n" : "");
        wanted = make_program("fullscreen.vert", "display.frag", defines);
    }
    return wanted;
}

void DisplayPass::set_analysis(const Program& program, const RenderFrame& frame, const Viewport& viewport) const {
    const BoostedView view = boosted_view(frame.eye);
    const ScreenRays rays = screen_rays(view);
    const glm::vec3 across = static_cast<float>(frame.eye.width) * rays.right;
    const glm::vec3 upwards = static_cast<float>(frame.eye.height) * rays.up;
    const ShiftScale shift = shift_scale(sim::Rapidity(view.rapidity));
    const BrightnessScale brightness;
    const GLuint name = program.name();
    glProgramUniform3fv(name, ray_origin, 1, glm::value_ptr(rays.origin));
    glProgramUniform3fv(name, ray_across, 1, glm::value_ptr(across));
    glProgramUniform3fv(name, ray_upwards, 1, glm::value_ptr(upwards));
    glProgramUniform1f(name, exp_rapidity, rays.exp_rapidity);
    glProgramUniform1i(name, shown_view, static_cast<GLint>(frame.display.view));
    glProgramUniform1i(name, iso_lines, frame.display.iso_lines ? 1 : 0);
    glProgramUniform2f(name, scale_of_shift, static_cast<float>(shift.range), static_cast<float>(shift.step));
    glProgramUniform3f(name, scale_of_brightness, static_cast<float>(brightness.darkest),
                       static_cast<float>(brightness.brightest), static_cast<float>(brightness.step));
    glProgramUniform2f(name, shown_pixel, 1.0f / static_cast<float>(viewport.width),
                       1.0f / static_cast<float>(viewport.height));
}

void DisplayPass::draw(const RenderFrame& frame, GLuint light, double factor, unsigned target_framebuffer,
                       const Viewport& viewport) {
    const glm::ivec2 size(frame.eye.width, frame.eye.height);
    const bool same_size = viewport.width == size.x && viewport.height == size.y;
    const GLuint cells = frame.display.bloom > 0.0f ? bloom_.scatter(light, size) : 0;
    const bool analysis = frame.display.view != View::natural || frame.display.iso_lines;
    const Program& shown = program(cells != 0, analysis);
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB); // the shader encodes
    glProgramUniform1f(shown.name(), exposure, static_cast<float>(factor));
    glProgramUniform1i(shown.name(), filmic_curve, frame.exposure.linear_curve ? 0 : 1);
    glProgramUniform2f(shown.name(), corner, static_cast<float>(viewport.x), static_cast<float>(viewport.y));
    glProgramUniform1i(shown.name(), dither, frame.display.dither ? 1 : 0);
    glProgramUniform1f(shown.name(), brightest, frame.display.brightest);
    if (cells != 0) {
        glProgramUniform1f(shown.name(), bloom_share, frame.display.bloom);
        glProgramUniform2f(shown.name(), picture_size, static_cast<float>(size.x), static_cast<float>(size.y));
        glBindTextureUnit(1, cells);
    }
    if (analysis) {
        set_analysis(shown, frame, viewport);
    }
    glUseProgram(shown.name());
    glBindVertexArray(no_attributes_.name());
    glBindTextureUnit(0, light);
    glBindSampler(0, same_size ? nearest_.name() : smooth_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
}

} // namespace render

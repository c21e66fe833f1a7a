#include "render/gl/ray_pass.h"

#include "render/raycast/packet_glare.h"

#include <utility>

namespace render {
namespace {

std::size_t pixel_count(const LightPackets& packets) {
    return static_cast<std::size_t>(packets.width) * static_cast<std::size_t>(packets.height);
}

} // namespace

RayPass::RayPass(content::SceneDesc scene, const SceneColour& colour)
    : scene_(std::make_unique<const content::SceneDesc>(std::move(scene))), caster_(*scene_, colour) {}

void RayPass::cast(const RenderFrame& frame, double pre_exposure, StereoShare* share, bool keep_depth) {
    depths_.resize(keep_depth ? static_cast<std::size_t>(frame.eye.width) * static_cast<std::size_t>(frame.eye.height)
                              : 0);
    caster_.light(frame, pre_exposure, packets_, share, depths_);
}

void RayPass::add_stars(const RenderFrame& frame, double pre_exposure, StereoShare* share) {
    caster_.add_stars(frame, pre_exposure, packets_, share);
}

MeteredLight RayPass::metered(double pre_exposure) const {
    return render::metered(packets_, pre_exposure);
}

Picture RayPass::picture(float factor) const {
    return light_picture(packets_, factor);
}

bool RayPass::shows(const Display& display) {
    return display.view == View::natural && !display.iso_lines;
}

void RayPass::show(const RenderFrame& frame, double factor, unsigned target_framebuffer, const Viewport& viewport) {
    const bool glare = frame.display.bloom > 0.0f;
    if (glare) {
        add_glare(packets_, frame.display.bloom, with_glare_);
    }
    const ByteLayout layout = BytePicture::layout_for(target_framebuffer);
    const DisplaySettings settings{static_cast<float>(factor), frame.exposure.linear_curve, frame.display.brightest,
                                   frame.display.dither};
    on_screen_.show(display_.show(glare ? with_glare_ : packets_, settings, {viewport.width, viewport.height}, layout),
                    layout, target_framebuffer, viewport);
}

void RayPass::load(const RenderTarget& target) {
    halves_.resize(pixel_count(packets_));
    write_halves(packets_, halves_);
    glTextureSubImage2D(target.colour(), 0, 0, 0, packets_.width, packets_.height, GL_RGBA, GL_HALF_FLOAT,
                        halves_.data());
}

void RayPass::copy_depth(GLuint texture) const {
    glTextureSubImage2D(texture, 0, 0, 0, packets_.width, packets_.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        depths_.data());
}

} // namespace render

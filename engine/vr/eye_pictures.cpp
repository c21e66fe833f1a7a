#include "engine/vr/eye_pictures.h"

#include <epoxy/gl.h>

#include <cmath>

namespace engine {
namespace {

/// The pictures are encoded as sRGB; a runtime that has no such format takes them as they are.
constexpr std::array<std::int64_t, 2> colour_formats{GL_SRGB8_ALPHA8, GL_RGBA8};

XrFovf field_of_view(const EyeScreen& screen) {
    const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
    return {angle(screen.left()), angle(screen.right()), angle(screen.up()), angle(screen.down())};
}

} // namespace

EyePictures::EyePictures(const input::XrFlightSession& session)
    : width_(session.runtime().recommended_width()), height_(session.runtime().recommended_height()) {
    for (std::size_t i = 0; i < 2; ++i) {
        using input::XrSwapchainOfTextures;
        eyes_.push_back({Offscreen(width_, height_),
                         std::make_unique<XrSwapchainOfTextures>(session, width_, height_,
                                                                 XrSwapchainOfTextures::Use::colour, colour_formats)});
    }
}

std::array<EyeScreen, 2> EyePictures::screens(const input::XrEyes& eyes) const {
    return eye_screens(eyes, width_, height_);
}

void EyePictures::draw(render::Renderer& renderer, const std::array<render::RenderFrame, 2>& frames,
                       const std::array<EyeScreen, 2>& screens) {
    screens_ = screens;
    eye_views_ = {frames[0].eye, frames[1].eye};
    std::array<render::RenderFrame, 2> both = frames;
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const render::EyeView& eye = both.at(i).eye;
        statistics_.at(i) = renderer.draw(both.at(i), eyes_[i].picture.framebuffer(), {0, 0, eye.width, eye.height});
        // Both eyes are exposed alike, by what the left one sees.
        both[1].exposure.automatic = false;
        both[1].exposure.stops = static_cast<float>(statistics_[0].exposure_stops);
    }
}

void EyePictures::hand_over() {
    for (Eye& eye : eyes_) {
        const GLuint texture = eye.shown->acquire();
        glCopyImageSubData(eye.picture.texture(), GL_TEXTURE_2D, 0, 0, 0, 0, texture, GL_TEXTURE_2D, 0, 0, 0, 0, width_,
                           height_, 1);
        eye.shown->release();
    }
}

const XrCompositionLayerBaseHeader* EyePictures::layer(const input::XrFlightSession& session,
                                                       const input::XrPlace& base_from_head,
                                                       const input::XrEyes& eyes) {
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        const EyeScreen& screen = screens_.at(i);
        views_.at(i) = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW,
                        nullptr,
                        input::pose_of(base_from_head * eyes.at(i).head_from_eye),
                        field_of_view(screen),
                        {eyes_[i].shown->handle(), {{0, 0}, {screen.width, screen.height}}, 0}};
    }
    layer_ = {XR_TYPE_COMPOSITION_LAYER_PROJECTION, nullptr, 0, session.base_space(), 2, views_.data()};
    return reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer_);
}

} // namespace engine

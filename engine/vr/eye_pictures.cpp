#include "engine/vr/eye_pictures.h"

#include "input/xr_failure.h"

#include <epoxy/gl.h>

#include <cmath>
#include <limits>

namespace engine {
namespace {

/// The pictures are encoded as sRGB; a runtime that has no such format takes them as they are.
constexpr std::array<std::int64_t, 2> colour_formats{GL_SRGB8_ALPHA8, GL_RGBA8};
constexpr std::array<std::int64_t, 1> depth_formats{GL_DEPTH_COMPONENT32F};

XrFovf field_of_view(const EyeScreen& screen) {
    const auto angle = [](double tangent) { return static_cast<float>(std::atan(tangent)); };
    return {angle(screen.left()), angle(screen.right()), angle(screen.up()), angle(screen.down())};
}

} // namespace

EyePictures::EyePictures(const input::XrFlightSession& session, const PictureSize& size)
    : width_(size.width), height_(size.height) {
    for (std::size_t i = 0; i < 2; ++i) {
        using input::XrSwapchainOfTextures;
        using Use = XrSwapchainOfTextures::Use;
        eyes_.push_back({Offscreen(width_, height_),
                         std::make_unique<XrSwapchainOfTextures>(session, width_, height_, Use::colour, colour_formats),
                         nullptr});
        if (session.runtime().takes_depth()) {
            try {
                eyes_.back().depth =
                    std::make_unique<XrSwapchainOfTextures>(session, width_, height_, Use::depth, depth_formats);
            } catch (const input::XrFailure& failure) {
                if (failure.cause() != input::XrFailure::Cause::unsuited) {
                    throw;
                }
            }
        }
    }
}

std::array<EyeScreen, 2> EyePictures::screens(const input::XrEyes& eyes) const {
    return eye_screens(eyes, width_, height_);
}

void EyePictures::draw(render::Renderer& renderer, const input::XrEyes& eyes,
                       const std::array<render::RenderFrame, 2>& frames, const std::array<EyeScreen, 2>& screens,
                       const std::array<render::CabinView, 2>& in_vehicle, const EyeOverlay& overlay) {
    screens_ = screens;
    eye_views_ = {frames[0].eye, frames[1].eye};
    share_.begin(whole_view(eyes, frames[0].eye, screens));
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const render::EyeView& eye = frames.at(i).eye;
        const GLuint picture = eyes_[i].picture.framebuffer();
        const render::Viewport viewport{0, 0, eye.width, eye.height};
        render::RenderFrame frame = frames.at(i);
        frame.keep_depth = eyes_[i].depth != nullptr && !overlay;
        statistics_.at(i) = renderer.draw(frame, picture, viewport, &share_);
        // A texture of the runtime's that is not handed over keeps the last depths: the layer leaves them out.
        bool copied = false;
        if (frame.keep_depth) {
            copied = renderer.copy_depth(eyes_[i].depth->acquire());
            eyes_[i].depth->release();
        }
        depth_shown_ = copied && (i == 0 || depth_shown_);
    }
    for (std::size_t i = 0; overlay && i < eyes_.size(); ++i) { // after both: the light it looks for is a picture, too
        const render::EyeView& eye = frames.at(i).eye;
        overlay(in_vehicle.at(i), frames.at(i), statistics_.at(i).exposure_stops, eyes_[i].picture.framebuffer(),
                {0, 0, eye.width, eye.height});
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
        const XrRect2Di area{{0, 0}, {screen.width, screen.height}};
        if (depth_shown_) {
            // Reversed: what the least depth means is infinitely far.
            depths_.at(i) = {XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR,
                             nullptr,
                             {eyes_[i].depth->handle(), area, 0},
                             0.0F,
                             1.0F,
                             std::numeric_limits<float>::infinity(),
                             static_cast<float>(render::nearest_depth)};
        }
        views_.at(i) = {XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW,
                        depth_shown_ ? &depths_.at(i) : nullptr,
                        input::pose_of(base_from_head * eyes.at(i).head_from_eye),
                        field_of_view(screen),
                        {eyes_[i].shown->handle(), area, 0}};
    }
    layer_ = {XR_TYPE_COMPOSITION_LAYER_PROJECTION, nullptr, 0, session.base_space(), 2, views_.data()};
    return reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer_);
}

} // namespace engine

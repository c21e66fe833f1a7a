#include "engine/frame_maker.h"

#include "engine/picture_maker.h"
#include "render/colour/scene_colour.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/offline/reference.h"
#include "render/raycast/ray_caster.h"

#include <optional>

namespace engine {

/// What the method in use needs.
struct FrameMaker::Renderers {
    std::optional<render::EglContext> context;
    std::optional<render::Renderer> opengl;
    std::optional<render::SceneColour> colour;
    std::optional<render::RayCaster> ray;
    std::optional<render::ReferenceRenderer> reference;
};

FrameMaker::FrameMaker(const content::SceneDesc& scene, PictureMethod method, int samples_per_side)
    : method_(chosen_method(method)), samples_per_side_(samples_per_side), renderers_(std::make_unique<Renderers>()) {
    switch (method_) {
    case PictureMethod::reference:
        renderers_->reference.emplace(scene);
        break;
    case PictureMethod::ray:
        renderers_->colour.emplace(scene);
        renderers_->ray.emplace(scene, *renderers_->colour);
        break;
    default:
        renderers_->context.emplace();
        renderers_->opengl.emplace(scene, render::RendererSettings{render::Method::texture});
    }
}

FrameMaker::~FrameMaker() = default;
FrameMaker::FrameMaker(FrameMaker&&) noexcept = default;
FrameMaker& FrameMaker::operator=(FrameMaker&&) noexcept = default;

render::Picture FrameMaker::picture(render::RenderFrame frame) {
    if (renderers_->reference) {
        return renderers_->reference->render(frame, samples_per_side_);
    }
    frame.eye.width *= samples_per_side_;
    frame.eye.height *= samples_per_side_;
    return averaged(renderers_->ray ? renderers_->ray->picture(frame) : radiance_picture(*renderers_->opengl, frame),
                    samples_per_side_);
}

render::Picture averaged(const render::Picture& fine, int side) {
    if (side == 1) {
        return fine;
    }
    render::Picture picture{fine.width / side, fine.height / side, fine.channels, {}};
    const auto channels = static_cast<std::size_t>(fine.channels);
    const auto fine_width = static_cast<std::size_t>(fine.width);
    const auto step = static_cast<std::size_t>(side);
    const float share = 1.0f / static_cast<float>(side * side);
    const auto width = static_cast<std::size_t>(picture.width);
    const auto height = static_cast<std::size_t>(picture.height);
    picture.values.resize(width * height * channels);
    for (std::size_t row = 0; row < height; ++row) {
        for (std::size_t column = 0; column < width; ++column) {
            for (std::size_t channel = 0; channel < channels; ++channel) {
                float sum = 0.0f;
                for (std::size_t y = row * step; y < (row + 1) * step; ++y) {
                    for (std::size_t x = column * step; x < (column + 1) * step; ++x) {
                        sum += fine.values[(y * fine_width + x) * channels + channel];
                    }
                }
                picture.values[(row * width + column) * channels + channel] = share * sum;
            }
        }
    }
    return picture;
}

} // namespace engine

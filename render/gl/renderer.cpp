#include "render/gl/renderer.h"

#include "render/gl/egl_context.h"
#include "render/gl/gl_objects.h"

#include <array>

namespace render {

class Renderer::Implementation {
  public:
    explicit Implementation(const content::SceneDesc& scene) : background_(scene.gradient_sky.horizon) {
        require_opengl_45();
    }

    void draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport) {
        statistics_.sharpness = frame.sharpness;
        const std::array<float, 4> colour{background_.r, background_.g, background_.b, 1.0f};
        glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
        glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
        glClearBufferfv(GL_COLOR, 0, colour.data());
    }

    Picture picture(const RenderFrame& frame) const {
        Picture result{frame.eye.width, frame.eye.height, 3, {}};
        for (int i = 0; i < result.width * result.height; ++i) {
            result.values.insert(result.values.end(), {background_.r, background_.g, background_.b});
        }
        return result;
    }

    const FrameStatistics& statistics() const { return statistics_; }

  private:
    glm::vec3 background_;
    FrameStatistics statistics_;
};

Renderer::Renderer(const content::SceneDesc& scene, const RendererSettings& /*settings*/)
    : implementation_(std::make_unique<Implementation>(scene)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

FrameStatistics Renderer::draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport) {
    implementation_->draw(frame, target_framebuffer, viewport);
    return statistics();
}

Picture Renderer::picture(const RenderFrame& frame) {
    return implementation_->picture(frame);
}

const FrameStatistics& Renderer::statistics() const {
    return implementation_->statistics();
}

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "engine/picture_request.h"
#include "render/render_frame.h"

#include <memory>

namespace engine {

/// Makes one picture after another of a scene, by one method.
class FrameMaker {
  public:
    /// `method`: texture, ray or reference, or automatic. `samples_per_side`: squared, samples of a pixel. Keeps a
    /// reference: `scene` must outlive this. Throws sim::BadInput when OpenGL cannot do it.
    FrameMaker(const content::SceneDesc& scene, PictureMethod method, int samples_per_side);
    ~FrameMaker();
    FrameMaker(FrameMaker&&) noexcept;
    FrameMaker& operator=(FrameMaker&&) noexcept;

    PictureMethod method() const { return method_; }
    /// Light as radiance, before any exposure; `frame` says for which screen.
    render::Picture picture(render::RenderFrame frame);

  private:
    struct Renderers;
    PictureMethod method_;
    int samples_per_side_;
    std::unique_ptr<Renderers> renderers_;
};

/// The mean of each square of `side` x `side` pixels.
render::Picture averaged(const render::Picture& fine, int side);

} // namespace engine

#pragma once

#include "render/cabin/cabin_view.h"
#include "render/gl/gl_objects.h"
#include "render/gl/renderer.h"

namespace render {

/// What eases a finished picture for whoever it makes ill. Both act on the encoded picture.
struct ComfortEffects {
    float narrowing = 0.0f; ///< of the view, in [0, 1]: shared/comfort.glsl
    float fade = 0.0f;      ///< of all of it, in [0, 1]; 1: black
};

/// Darkens a finished picture. OpenGL 4.5 as Renderer.
class ComfortPass {
  public:
    ComfortPass();

    /// Draws over `viewport` of the framebuffer; nothing where there is no effect.
    void draw(const ViewTangents& tangents, const ComfortEffects& effects, unsigned target_framebuffer,
              const Viewport& viewport);

  private:
    Program program_;
    VertexArray no_attributes_;
};

} // namespace render

#pragma once

#include "content/generator/cabin.h"
#include "render/cabin/cabin_light.h"
#include "render/cabin/cabin_view.h"
#include "render/gl/gl_objects.h"
#include "render/gl/renderer.h"

#include <glm/vec3.hpp>

#include <vector>

namespace render {

/// How the cabin's light becomes colours: as the picture's around it does.
struct CabinExposure {
    double stops = 0.0; ///< log2 of the factor on radiance
    bool linear_curve = false;
    float brightest = 1.0f; ///< see Display::brightest
};

/// Draws the cabin over a finished picture, with its own depth, smoothed edges and light. OpenGL 4.5 as Renderer.
class CabinPass {
  public:
    explicit CabinPass(const content::generator::Cabin& cabin);

    /// The light from now on: of it all surfaces are matte with a thin gloss, which mirrors what comes from around the
    /// more the more grazingly it is looked at (Fresnel, by Schlick 1994), as far as a vertex is open to the outside.
    void set_light(const CabinLight& cabin, const LightFromAround& light);

    /// Draws into `viewport` of the framebuffer; what the cabin does not cover stays. `panel`: a texture with the
    /// instruments' picture, encoded, as the screens show it; 0: the screens are dark.
    void draw(const CabinView& view, const CabinExposure& exposure, GLuint panel, unsigned target_framebuffer,
              const Viewport& viewport);

  private:
    void resize(const glm::ivec2& size);

    Program cabin_program_;
    Program screen_program_;
    Program cover_program_;
    Buffer positions_;
    Buffer normals_;
    Buffer light_;
    Buffer indices_;
    Buffer screens_;
    VertexArray cabin_array_;
    VertexArray screen_array_;
    VertexArray no_attributes_;
    Sampler panel_sampler_;
    Sampler around_sampler_;
    Texture around_; ///< radiance from outside by direction, cabin frame
    GLsizei index_count_ = 0;
    GLsizei screen_count_ = 0; ///< vertices
    glm::ivec2 size_{0};
    Texture samples_;
    Texture depth_;
    Framebuffer sampled_;
    Texture smooth_;
    Framebuffer resolved_;
};

} // namespace render

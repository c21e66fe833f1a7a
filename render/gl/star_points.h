#pragma once

#include "content/scene_desc.h"
#include "render/colour/doppler_colour.h"
#include "render/gl/gl_objects.h"
#include "render/render_frame.h"

namespace render {

/// The stars of a scene (at least one) as points in OpenGL: where aberration puts them, with the colour of a black body
/// at T/D, their light spread over a footprint of a few pixels that keeps its sum wherever the star lies between
/// pixels. As the eye travels, parallax and distance show: positions relative to the eye keep double precision.
class StarPoints {
  public:
    StarPoints(const content::SceneDesc& scene, const DopplerColour& colour);

    /// Draws the stars' light times `pre_exposure` with the blending that is set, into the bound framebuffer, whose
    /// lower left frame.eye.width x height pixels are the picture. Leaves the viewport a little wider than that.
    void draw(const RenderFrame& frame, const sim::BoostAndRotation& eye, double pre_exposure) const;

  private:
    GLsizei count_ = 0;
    Program program_;
    Buffer vertices_;
    VertexArray vertex_array_;
    Texture black_bodies_;
    glm::vec2 coordinate_{0.0f}; ///< scale and offset of the texture coordinate on ln T
};

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/colour/star_photometry.h"
#include "render/render_frame.h"

#include <glm/vec4.hpp>

#include <vector>

namespace render {

/// The stars of a scene as a picture of its own, computed on the CPU in double precision: where aberration puts each,
/// coloured as a black body at T/D, its light spread over the footprint of shared/star.glsl. For software OpenGL, where
/// a point costs more than this (see StarLayer).
class StarSheet {
  public:
    /// Keeps a reference: `colour` must outlive this.
    StarSheet(const content::SceneDesc& scene, const DopplerColour& colour);

    bool empty() const { return stars_.empty(); }

    /// Radiance of the stars times `scale`, as if no scenery hid them: frame.eye.width x height, rows from the top, w
    /// is 0. Stars whose brightest pixel would be below `faintest` are left out. `pixels` is overwritten.
    void draw(const RenderFrame& frame, double scale, double faintest, std::vector<glm::vec4>& pixels) const;

  private:
    struct Placed {
        glm::dvec3 position{0.0}; ///< light-years, world
        StarSource source;
    };
    /// A star on the screen: pixels from the upper left corner, and its radiance if all of it fell into one pixel.
    struct Spot {
        glm::vec2 centre{0.0f};
        glm::vec3 light{0.0f};
    };

    std::vector<Spot> spots(const RenderFrame& frame, double scale, double faintest) const;

    const DopplerColour& colour_;
    std::vector<Placed> stars_;
};

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/colour/star_photometry.h"
#include "render/render_frame.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tbb/parallel_for.h>
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

    /// The same, handed out: calls add(column, row from the top, light) for every pixel that a star sheds light on, for
    /// each pixel star after star; bands of rows on all processors.
    template <class Add>
    void for_each_share(const RenderFrame& frame, double scale, double faintest, const Add& add) const {
        const std::vector<Spot> found = spots(frame, scale, faintest);
        constexpr int bands = 16;
        const int height = (frame.eye.height + bands - 1) / bands;
        tbb::parallel_for(0, bands, [&](int band) {
            const int top = band * height;
            const int bottom = std::min(top + height, frame.eye.height);
            for (const Spot& spot : found) {
                if (spot.centre.y > static_cast<float>(top - footprint) &&
                    spot.centre.y < static_cast<float>(bottom + footprint)) {
                    spread(spot, frame.eye.width, top, bottom, add);
                }
            }
        });
    }

  private:
    static constexpr int footprint = 6; ///< star_footprint
    /// Shares of the pixels left-to-right or top-to-bottom from `first` on.
    struct Shares {
        explicit Shares(float centre);
        int first;
        std::array<float, static_cast<std::size_t>(footprint)> values{};
    };
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

    /// Hands out what falls into the rows from `top` to before `bottom`.
    template <class Add>
    static void spread(const Spot& spot, int width, int top, int bottom, const Add& add) {
        const Shares across(spot.centre.x);
        const Shares down(spot.centre.y);
        for (int row = std::max(down.first, top); row < std::min(down.first + footprint, bottom); ++row) {
            const glm::vec3 in_row = down.values[static_cast<std::size_t>(row - down.first)] * spot.light;
            for (int column = std::max(across.first, 0); column < std::min(across.first + footprint, width); ++column) {
                add(column, row, across.values[static_cast<std::size_t>(column - across.first)] * in_row);
            }
        }
    }

    const DopplerColour& colour_;
    std::vector<Placed> stars_;
};

} // namespace render

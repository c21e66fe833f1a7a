#pragma once

#include "render/offline/traced/projection.h"
#include "render/offline/traced/traced_ray.h"
#include "render/offline/traced/traced_sky.h"
#include "render/offline/traced/traced_stars.h"
#include "render/offline/traced/traced_tile.h"

#include <array>
#include <span>
#include <vector>

namespace render {

/// What lies at infinity: [0] of the camera's side, [1] beyond a wormhole. Null where nothing shines.
struct TracedSkies {
    std::array<const SkyLight*, 2> light{};
    std::array<const StarField*, 2> stars{};
};

/// Makes the pixels of a tile from rays: a grid of samples in every pixel, four times as many where its samples
/// disagree (an edge: shadow, disk, object; a photon ring), sixteen times where they still do. A pixel depends on its
/// own rays and the stars near it alone, so tiles can be made anywhere, in any order.
class TilePainter {
  public:
    /// Keeps references. `samples_per_side` >= 2, along each side of a pixel.
    TilePainter(const CameraLens& lens, const RaySource& rays, const BundleMagnification& magnification,
                const TracedSkies& skies, const TracedColour& colour, int samples_per_side)
        : lens_(lens), rays_(rays), magnification_(magnification), skies_(skies), colour_(colour),
          samples_(samples_per_side) {}

    /// Fills `tile.values` for the rectangle that the tile says.
    void paint(TracedTile& tile) const;

  private:
    /// Makes these pixels with samples^2 rays each; returns those whose samples disagree.
    std::vector<std::size_t> paint_pixels(TracedTile& tile, const std::vector<std::size_t>& pixels, int samples) const;
    /// The directions of all samples of the pixels that are wholly in the picture; returns those pixels.
    std::vector<std::size_t> directions_of(const TracedTile& tile, std::span<const std::size_t> pixels, int samples,
                                           std::vector<glm::dvec3>& directions) const;
    /// One pixel from its rays; whether they agree.
    bool paint_pixel(TracedTile& tile, std::size_t pixel, std::span<const TracedRay> rays, int samples) const;

    const CameraLens& lens_;
    const RaySource& rays_;
    const BundleMagnification& magnification_;
    const TracedSkies& skies_;
    const TracedColour& colour_;
    int samples_;
};

} // namespace render

#pragma once

#include "render/gl/boosted_view.h"

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <vector>

/// Which perspective pictures of the world at rest a warped view needs. No OpenGL, double precision.
///
/// The screen is cut into rectangular blocks. Each block has its own picture plane in the world: the projective map
/// from directions to texels that agrees with the warp at the block's centre in place and in all first derivatives,
/// and whose magnification also has the warp's gradient there. So one texel stays close to one pixel all over the
/// block, blocks can be large, and a pixel knows its tile from where it is on the screen.
namespace render {

/// A block of pixels and the picture of the world that it is drawn from.
struct Tile {
    glm::ivec2 block_low{0}; ///< pixels from the screen's lower left corner
    glm::ivec2 block_high{0};
    glm::ivec2 size{0};         ///< texels, gutter included
    glm::ivec2 atlas_corner{0}; ///< lower left, texels
    /// Homogeneous texel coordinates within the tile from a direction in the axis frame. Scaled so that the third
    /// component, for unit directions in the block, is at most 1.
    glm::dmat3 texels_from_axis{1.0};
};

struct TilePlan {
    std::vector<Tile> tiles;
    glm::ivec2 atlas_size{0};
    double texels_per_pixel = 0.0;
    double sharpness = 1.0; ///< the one achieved; less than asked for when the atlas would not fit
};

/// Texels around a block's own that are drawn too, for filtering.
constexpr int tile_gutter = 2;

/// The one tile of an eye at rest: the screen itself, a texel a pixel.
TilePlan plan_plain(const BoostedView& view);

/// Plans the tiles of a view so that everywhere at least `sharpness` texels, in any direction on the screen, meet a
/// pixel. The atlas keeps within `largest_atlas` texels each side, at reduced sharpness if need be.
TilePlan plan_tiles(const BoostedView& view, double sharpness, int largest_atlas);

} // namespace render

#pragma once

#include "render/offline/traced/traced_tile.h"

#include <cstddef>

namespace engine {

/// The pictures of a sequence cut into tiles, numbered frame by frame, row by row.
class TilePlan {
  public:
    static constexpr int tile_side = 64; ///< pixels

    TilePlan(int frames, int width, int height)
        : frames_(frames), width_(width), height_(height), columns_((width + tile_side - 1) / tile_side),
          rows_((height + tile_side - 1) / tile_side) {}

    std::size_t tiles_per_frame() const { return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_); }
    std::size_t count() const { return static_cast<std::size_t>(frames_) * tiles_per_frame(); }
    int frames() const { return frames_; }
    int width() const { return width_; }
    int height() const { return height_; }
    int frame_of(std::size_t tile) const { return static_cast<int>(tile / tiles_per_frame()); }

    /// Where the tile lies; without values.
    render::TracedTile place_of(std::size_t tile) const {
        const auto in_frame = static_cast<int>(tile % tiles_per_frame());
        render::TracedTile place;
        place.left = in_frame % columns_ * tile_side;
        place.top = in_frame / columns_ * tile_side;
        place.width = place.left + tile_side > width_ ? width_ - place.left : tile_side;
        place.height = place.top + tile_side > height_ ? height_ - place.top : tile_side;
        return place;
    }

  private:
    int frames_;
    int width_;
    int height_;
    int columns_;
    int rows_;
};

} // namespace engine

#pragma once

#include "render/colour/bloom.h"
#include "render/colour/linear_filter.h"
#include "render/raycast/lanes.h"

#include <glm/vec2.hpp>

#include <functional>
#include <span>
#include <vector>

namespace render {

/// What glare in the eye spreads around every pixel of a picture (see bloomed), on all processors. Rows may come from
/// the top or from the bottom.
class ScatteredLight {
  public:
    /// Puts a row's pixels, red, green, blue and anything, into the span; called from several threads.
    using ReadRow = std::function<void(int row, std::span<Four> pixels)>;

    /// Of a picture large enough to scatter in (BloomGrid::levels > 0).
    ScatteredLight(const glm::ivec2& picture, const ReadRow& read_row);

    /// What is scattered onto the pixels of a row.
    void around(int row, std::span<Four> pixels) const;

  private:
    /// A level of the pyramid, row by row.
    struct Level {
        glm::ivec2 size{0};
        std::vector<Four> cells;

        explicit Level(const glm::ivec2& count);
        std::span<Four> row(int y);
        std::span<const Four> row(int y) const;
    };

    void read_finest(const glm::ivec2& picture, const ReadRow& read_row);
    void coarsen(std::size_t level);
    void spread(std::size_t level);

    glm::ivec2 picture_;
    std::vector<Level> levels_;    ///< from the finest
    std::vector<Between> columns_; ///< of the finest level, for each pixel of a row
};

} // namespace render

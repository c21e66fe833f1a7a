#include "render/colour/scattered_light.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <tbb/parallel_for.h>

namespace render {
namespace shared {
using glm::floor;
using glm::max;
using glm::min;
namespace {
#include "render/shaders/shared/bloom.glsl"
} // namespace
} // namespace shared
namespace {

/// Pixels that a finest cell, which is at most two long, covers of a row or a column, and their shares of it.
struct Covered {
    static constexpr int most = 3;

    Covered(int cell, float pixels_per_cell, int pixels) {
        const float low = static_cast<float>(cell) * pixels_per_cell;
        for (int i = 0; i < most; ++i) {
            const int pixel = static_cast<int>(low) + i;
            share.at(static_cast<std::size_t>(i)) =
                shared::bloom_overlap(static_cast<float>(pixel), low, low + pixels_per_cell) / pixels_per_cell;
            at.at(static_cast<std::size_t>(i)) = std::min(pixel, pixels - 1);
        }
    }

    std::array<int, most> at{};
    std::array<float, most> share{};
};

} // namespace

ScatteredLight::Level::Level(const glm::ivec2& count)
    : size(count), cells(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y)) {}

std::span<Four> ScatteredLight::Level::row(int y) {
    return std::span(cells).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x),
                                    static_cast<std::size_t>(size.x));
}

std::span<const Four> ScatteredLight::Level::row(int y) const {
    return std::span(cells).subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x),
                                    static_cast<std::size_t>(size.x));
}

ScatteredLight::ScatteredLight(const glm::ivec2& picture, const ReadRow& read_row) : picture_(picture) {
    const BloomGrid grid(picture);
    for (int level = 1; level <= grid.levels; ++level) {
        levels_.emplace_back(grid.cells(level));
    }
    read_finest(picture, read_row);
    for (std::size_t level = 1; level < levels_.size(); ++level) {
        coarsen(level);
    }
    for (std::size_t level = levels_.size() - 1; level > 0; --level) {
        spread(level - 1);
    }
    const float cells_per_pixel = static_cast<float>(grid.finest.x) / static_cast<float>(picture.x);
    for (int x = 0; x < picture.x; ++x) {
        columns_.emplace_back(shared::bloom_place(static_cast<float>(x), cells_per_pixel), grid.finest.x);
    }
}

void ScatteredLight::read_finest(const glm::ivec2& picture, const ReadRow& read_row) {
    Level& finest = levels_.front();
    const glm::vec2 pixels_per_cell = glm::vec2(picture) / glm::vec2(finest.size);
    std::vector<Covered> columns;
    columns.reserve(static_cast<std::size_t>(finest.size.x));
    for (int x = 0; x < finest.size.x; ++x) {
        columns.emplace_back(x, pixels_per_cell.x, picture.x);
    }
    tbb::parallel_for(0, finest.size.y, [&](int y) {
        std::vector<Four> pixels(static_cast<std::size_t>(picture.x));
        std::vector<Four> sum(pixels.size());
        const Covered rows(y, pixels_per_cell.y, picture.y);
        for (std::size_t i = 0; i < Covered::most; ++i) {
            if (rows.share.at(i) > 0.0f) {
                read_row(rows.at.at(i), pixels);
                for (std::size_t x = 0; x < sum.size(); ++x) {
                    sum[x] += rows.share.at(i) * pixels[x];
                }
            }
        }
        const std::span<Four> cells = finest.row(y);
        for (std::size_t x = 0; x < cells.size(); ++x) {
            const Covered& covered = columns[x];
            const auto part = [&](std::size_t i) {
                return covered.share[i] * sum[static_cast<std::size_t>(covered.at[i])];
            };
            cells[x] = part(0) + part(1) + part(2);
        }
    });
}

void ScatteredLight::coarsen(std::size_t level) {
    const Level& finer = levels_[level - 1];
    Level& coarser = levels_[level];
    tbb::parallel_for(0, coarser.size.y, [&](int y) {
        const std::span<const Four> one = finer.row(2 * y);
        const std::span<const Four> other = finer.row(2 * y + 1);
        const std::span<Four> cells = coarser.row(y);
        for (std::size_t x = 0; x < cells.size(); ++x) {
            cells[x] = 0.25f * (one[2 * x] + one[2 * x + 1] + other[2 * x] + other[2 * x + 1]);
        }
    });
}

void ScatteredLight::spread(std::size_t level) {
    // The finest cells only hand on what the next level is: their own light is hardly scattered.
    const float share = level == 0 ? 1.0f : bloom_spread;
    const Level& coarse = levels_[level + 1];
    Level& fine = levels_[level];
    tbb::parallel_for(0, fine.size.y, [&](int y) {
        const Between rows(0.5f * (static_cast<float>(y) + 0.5f), coarse.size.y);
        const std::span<const Four> one = coarse.row(rows.first);
        const std::span<const Four> other = coarse.row(rows.second);
        std::vector<Four> between(one.size());
        for (std::size_t x = 0; x < between.size(); ++x) {
            between[x] = one[x] + rows.share * (other[x] - one[x]);
        }
        const std::span<Four> cells = fine.row(y);
        for (std::size_t x = 0; x < cells.size(); ++x) {
            // A quarter of a cell left or right of a coarse one's centre.
            const std::size_t near = x / 2;
            const std::size_t far =
                x % 2 == 0 ? std::max<std::size_t>(near, 1) - 1 : std::min(near + 1, between.size() - 1);
            const Four around = 0.75f * between[near] + 0.25f * between[far];
            cells[x] += share * (around - cells[x]);
        }
    });
}

void ScatteredLight::around(int row, std::span<Four> pixels) const {
    const Level& finest = levels_.front();
    const float cells_per_pixel = static_cast<float>(finest.size.y) / static_cast<float>(picture_.y);
    const Between rows(shared::bloom_place(static_cast<float>(row), cells_per_pixel), finest.size.y);
    const std::span<const Four> one = finest.row(rows.first);
    const std::span<const Four> other = finest.row(rows.second);
    std::vector<Four> between(one.size());
    for (std::size_t x = 0; x < between.size(); ++x) {
        between[x] = one[x] + rows.share * (other[x] - one[x]);
    }
    for (std::size_t x = 0; x < pixels.size(); ++x) {
        const Between& columns = columns_[x];
        const Four left = between[static_cast<std::size_t>(columns.first)];
        pixels[x] = left + columns.share * (between[static_cast<std::size_t>(columns.second)] - left);
    }
}

} // namespace render

#include "render/colour/bloom.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <vector>

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

constexpr int most_levels = 7;

/// Light of cells, rows from the top.
struct Cells {
    explicit Cells(const glm::ivec2& count)
        : size(count), light(static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y)) {}

    glm::vec3& at(int x, int y) {
        return light[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
    }
    const glm::vec3& at(int x, int y) const {
        return light[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)];
    }
    /// Between the cells' centres, which lie at halves; held beyond the outermost.
    glm::vec3 linear(float x, float y) const {
        const float left = std::clamp(x - 0.5f, 0.0f, static_cast<float>(size.x - 1));
        const float top = std::clamp(y - 0.5f, 0.0f, static_cast<float>(size.y - 1));
        const int x0 = static_cast<int>(left);
        const int y0 = static_cast<int>(top);
        const int x1 = std::min(x0 + 1, size.x - 1);
        const int y1 = std::min(y0 + 1, size.y - 1);
        const float u = left - static_cast<float>(x0);
        return glm::mix(glm::mix(at(x0, y0), at(x1, y0), u), glm::mix(at(x0, y1), at(x1, y1), u),
                        top - static_cast<float>(y0));
    }

    glm::ivec2 size;
    std::vector<glm::vec3> light;
};

glm::vec3 pixel(const Picture& picture, int x, int y) {
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return {picture.values[at], picture.values[at + 1], picture.values[at + 2]};
}

Cells finest_cells(const Picture& light, const glm::ivec2& count) {
    Cells cells(count);
    const glm::vec2 length = glm::vec2(light.width, light.height) / glm::vec2(count);
    for (int y = 0; y < count.y; ++y) {
        const float top = static_cast<float>(y) * length.y;
        for (int x = 0; x < count.x; ++x) {
            const float left = static_cast<float>(x) * length.x;
            glm::vec3 sum(0.0f);
            for (int row = static_cast<int>(top); row < light.height; ++row) {
                const float height = shared::bloom_overlap(static_cast<float>(row), top, top + length.y);
                if (height <= 0.0f) {
                    break;
                }
                for (int column = static_cast<int>(left); column < light.width; ++column) {
                    const float width = shared::bloom_overlap(static_cast<float>(column), left, left + length.x);
                    if (width <= 0.0f) {
                        break;
                    }
                    sum += height * width * pixel(light, column, row);
                }
            }
            cells.at(x, y) = sum / (length.x * length.y);
        }
    }
    return cells;
}

Cells coarser(const Cells& finer) {
    Cells cells(finer.size / 2);
    for (int y = 0; y < cells.size.y; ++y) {
        for (int x = 0; x < cells.size.x; ++x) {
            cells.at(x, y) = 0.25f * (finer.at(2 * x, 2 * y) + finer.at(2 * x + 1, 2 * y) + finer.at(2 * x, 2 * y + 1) +
                                      finer.at(2 * x + 1, 2 * y + 1));
        }
    }
    return cells;
}

/// Mixes the coarser level into the finer one.
void spread(const Cells& coarse, Cells& finer, float share) {
    for (int y = 0; y < finer.size.y; ++y) {
        for (int x = 0; x < finer.size.x; ++x) {
            const glm::vec3 around =
                coarse.linear(0.5f * (static_cast<float>(x) + 0.5f), 0.5f * (static_cast<float>(y) + 0.5f));
            finer.at(x, y) = glm::mix(finer.at(x, y), around, share);
        }
    }
}

/// Cells along a side of n pixels: a multiple of 2^(levels - 1), at least half as many as pixels and at most as many.
int finest_count(int pixels, int levels) {
    const int largest = 1 << levels;
    return (pixels + largest - 1) / largest * (largest / 2);
}

} // namespace

BloomGrid::BloomGrid(const glm::ivec2& picture) {
    const int shorter = std::min(picture.x, picture.y);
    levels =
        shorter < 4 ? 0 : std::min(static_cast<int>(std::bit_width(static_cast<unsigned>(shorter))) - 1, most_levels);
    if (levels > 0) {
        finest = {finest_count(picture.x, levels), finest_count(picture.y, levels)};
    }
}

Picture bloomed(const Picture& light, float share) {
    const BloomGrid grid({light.width, light.height});
    if (grid.levels == 0 || share <= 0.0f) {
        return light;
    }
    std::vector<Cells> levels{finest_cells(light, grid.finest)};
    for (int level = 2; level <= grid.levels; ++level) {
        levels.push_back(coarser(levels.back()));
    }
    for (std::size_t level = levels.size() - 1; level > 0; --level) {
        // The finest cells only hand on what the next level is: their own light is hardly scattered.
        spread(levels[level], levels[level - 1], level == 1 ? 1.0f : bloom_spread);
    }
    Picture result = light;
    const glm::vec2 cells_per_pixel = glm::vec2(grid.finest) / glm::vec2(light.width, light.height);
    std::size_t at = 0;
    for (int y = 0; y < light.height; ++y) {
        const float row = shared::bloom_place(static_cast<float>(y), cells_per_pixel.y);
        for (int x = 0; x < light.width; ++x) {
            const glm::vec3 around =
                levels[0].linear(shared::bloom_place(static_cast<float>(x), cells_per_pixel.x), row);
            const glm::vec3 seen = glm::mix(pixel(light, x, y), around, share);
            for (int i = 0; i < 3; ++i) {
                result.values[at++] = seen[i];
            }
        }
    }
    return result;
}

} // namespace render

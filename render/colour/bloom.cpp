#include "render/colour/bloom.h"

#include "render/colour/scattered_light.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <tbb/parallel_for.h>
#include <vector>

namespace render {
namespace {

constexpr int most_levels = 7;

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
    const auto row_length = 3 * static_cast<std::size_t>(light.width);
    const ScatteredLight scattered({light.width, light.height}, [&](int row, std::span<Four> pixels) {
        const float* value = &light.values[static_cast<std::size_t>(row) * row_length];
        for (Four& pixel : pixels) {
            pixel = Four{value[0], value[1], value[2], 0.0f};
            value += 3;
        }
    });
    Picture result = light;
    tbb::parallel_for(0, light.height, [&](int row) {
        std::vector<Four> around(static_cast<std::size_t>(light.width));
        scattered.around(row, around);
        float* value = &result.values[static_cast<std::size_t>(row) * row_length];
        for (const Four& pixel : around) {
            for (int i = 0; i < 3; ++i) {
                *value = mixed_with_glare(*value, pixel[i], share);
                ++value;
            }
        }
    });
    return result;
}

} // namespace render

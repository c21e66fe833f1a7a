#include "render/raycast/texture_pool.h"

#include "content/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tbb/parallel_for.h>

namespace render {
namespace {

void add_levels(const content::Image& image, std::uint32_t& texels, std::vector<TextureLevel>& levels) {
    for (int width = image.width, height = image.height;;
         width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        levels.push_back({texels, width, height});
        texels += static_cast<std::uint32_t>(width) * static_cast<std::uint32_t>(height);
        if (width == 1 && height == 1) {
            return;
        }
    }
}

void decode(const content::Image& image, PackedFour* texels) {
    std::array<std::uint16_t, 256> linear{};
    for (std::size_t byte = 0; byte < linear.size(); ++byte) {
        linear[byte] = static_cast<std::uint16_t>(
            std::lround(65535.0f * content::linear_from_srgb(static_cast<float>(byte) / 255.0f)));
    }
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
        *texels++ = PackedFour{linear[image.rgba[i]], linear[image.rgba[i + 1]], linear[image.rgba[i + 2]],
                               static_cast<std::uint16_t>(257 * image.rgba[i + 3])};
    }
}

/// Where a texel of the coarser level begins in the finer one, whose sides need not be even.
double begin_of(int index, int coarse, int fine) {
    return static_cast<double>(index) * fine / coarse;
}

/// The part of a finer texel that lies between two places.
double share_of(int index, double begin, double end) {
    return std::min(end, index + 1.0) - std::max(begin, static_cast<double>(index));
}

void halve(const TextureLevel& fine, const PackedFour* source, const TextureLevel& coarse, PackedFour* target) {
    for (int y = 0; y < coarse.height; ++y) {
        const double top = begin_of(y, coarse.height, fine.height);
        const double bottom = begin_of(y + 1, coarse.height, fine.height);
        for (int x = 0; x < coarse.width; ++x) {
            const double left = begin_of(x, coarse.width, fine.width);
            const double right = begin_of(x + 1, coarse.width, fine.width);
            Four sum{};
            for (int row = static_cast<int>(top); row < bottom; ++row) {
                for (int column = static_cast<int>(left); column < right; ++column) {
                    const auto weight = static_cast<float>(share_of(row, top, bottom) * share_of(column, left, right));
                    sum += weight * unpacked(source[static_cast<std::ptrdiff_t>(row) * fine.width + column]);
                }
            }
            const Four mean = sum / static_cast<float>((bottom - top) * (right - left)) + 0.5f;
            *target++ = {static_cast<std::uint16_t>(mean[0]), static_cast<std::uint16_t>(mean[1]),
                         static_cast<std::uint16_t>(mean[2]), static_cast<std::uint16_t>(mean[3])};
        }
    }
}

/// One level of each lane's image.
struct LevelOfLanes {
    LaneIndices first; ///< texel
    Lanes width;
    Lanes height;

    void set(int lane, const TextureLevel& level) {
        first[lane] = level.first;
        width[lane] = static_cast<float>(level.width);
        height[lane] = static_cast<float>(level.height);
    }
};

/// A level's texels about each lane's place: the four nearest, and where between them.
struct Taps {
    LaneIndices upper_left;
    LaneIndices upper_right;
    LaneIndices lower_left;
    LaneIndices lower_right;
    Lanes right_share;
    Lanes lower_share;

    Four mixed(const std::vector<PackedFour>& pool, int i) const {
        const Four left = unpacked(pool[upper_left[i]]);
        const Four below_left = unpacked(pool[lower_left[i]]);
        const Four above = left + right_share[i] * (unpacked(pool[upper_right[i]]) - left);
        const Four below = below_left + right_share[i] * (unpacked(pool[lower_right[i]]) - below_left);
        return above + lower_share[i] * (below - above);
    }
};

RAPIDITY_VECTOR_CLONES
Taps taps_of(const TextureLookUp& look_up, const LevelOfLanes& level) {
    Taps taps;
    for (int i = 0; i < lane_count; ++i) {
        const auto columns = static_cast<int>(level.width[i]);
        const auto rows = static_cast<int>(level.height[i]);
        const float x = (look_up.u[i] - static_cast<float>(floor_of_lane(look_up.u[i]))) * level.width[i] - 0.5f;
        const float y = (look_up.v[i] - static_cast<float>(floor_of_lane(look_up.v[i]))) * level.height[i] - 0.5f;
        const int column = floor_of_lane(x);
        const int row = floor_of_lane(y);
        // Within [0, 1] of the image: at most one step beyond either edge, where it begins again.
        const int left = column < 0 ? columns - 1 : column;
        const int right = column + 1 < columns ? column + 1 : 0;
        const int upper = (row < 0 ? rows - 1 : row) * columns;
        const int lower = (row + 1 < rows ? row + 1 : 0) * columns;
        taps.right_share[i] = x - static_cast<float>(column);
        taps.lower_share[i] = y - static_cast<float>(row);
        taps.upper_left[i] = level.first[i] + static_cast<std::uint32_t>(upper + left);
        taps.upper_right[i] = level.first[i] + static_cast<std::uint32_t>(upper + right);
        taps.lower_left[i] = level.first[i] + static_cast<std::uint32_t>(lower + left);
        taps.lower_right[i] = level.first[i] + static_cast<std::uint32_t>(lower + right);
    }
    return taps;
}

} // namespace

void TexturePool::sample(const TextureLookUp& look_up, LaneMask wanted, std::array<Four, lane_count>& colours) const {
    constexpr float per_step = 1.0f / 65535.0f;
    LevelOfLanes finer;
    LevelOfLanes coarser;
    Lanes coarser_share;
    for (LaneMask rest = wanted; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        const std::uint32_t first = first_level_[look_up.image[i]];
        const std::uint32_t last = first_level_[look_up.image[i] + 1] - 1;
        const float level = std::clamp(look_up.level[i], 0.0f, static_cast<float>(last - first));
        const auto whole = static_cast<std::uint32_t>(level);
        coarser_share[i] = level - static_cast<float>(whole);
        finer.set(i, levels_[first + whole]);
        coarser.set(i, levels_[std::min(first + whole + 1, last)]);
    }
    const Taps fine = taps_of(look_up, finer);
    const Taps coarse = taps_of(look_up, coarser);
    for (LaneMask rest = wanted; rest != 0; rest &= rest - 1) {
        const int i = std::countr_zero(rest);
        Four colour = fine.mixed(texels_, i);
        if (coarser_share[i] > 0.0f) {
            colour += coarser_share[i] * (coarse.mixed(texels_, i) - colour);
        }
        colours[static_cast<std::size_t>(i)] = per_step * colour;
    }
}

TexturePool::TexturePool(const std::vector<content::Image>& images) {
    std::uint32_t texels = 0;
    for (const content::Image& image : images) {
        first_level_.push_back(static_cast<std::uint32_t>(levels_.size()));
        add_levels(image, texels, levels_);
    }
    first_level_.push_back(static_cast<std::uint32_t>(levels_.size()));
    texels_.resize(texels);
    tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
        decode(images[i], &texels_[levels_[first_level_[i]].first]);
        for (std::size_t level = first_level_[i] + 1; level < first_level_[i + 1]; ++level) {
            halve(levels_[level - 1], &texels_[levels_[level - 1].first], levels_[level],
                  &texels_[levels_[level].first]);
        }
    });
}

} // namespace render

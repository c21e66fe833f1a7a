#pragma once

#include "content/scene_desc.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace render {

/// Four numbers that are filtered together; one vector register everywhere.
using Four [[gnu::vector_size(16)]] = float;
using PackedFour = std::array<std::uint16_t, 4>;

/// The four integers as floats.
inline Four unpacked(const PackedFour& packed) {
    using Halves [[gnu::vector_size(16)]] = std::uint16_t;
    using Words [[gnu::vector_size(16)]] = std::int32_t;
    using Pair [[gnu::vector_size(16)]] = std::uint64_t;
    static_assert(std::endian::native == std::endian::little);
    const auto low = reinterpret_cast<Halves>(Pair{std::bit_cast<std::uint64_t>(packed), 0});
    const auto widened = __builtin_shuffle(low, Halves{}, Halves{0, 8, 1, 9, 2, 10, 3, 11});
    return __builtin_convertvector(reinterpret_cast<Words>(widened), Four);
}

/// One level of an image's mipmaps.
struct TextureLevel {
    std::size_t first = 0; ///< texel in TexturePool
    int width = 1;
    int height = 1;
};

/// A scene's images with mipmaps, decoded from sRGB so that filtering adds light: 8 bytes a texel, 16 bits a channel of
/// linear colour and alpha, a third more for the mipmaps.
class TexturePool {
  public:
    explicit TexturePool(const std::vector<content::Image>& images);

    float width(std::size_t image) const { return static_cast<float>(levels_[first_level_[image]].width); }
    float height(std::size_t image) const { return static_cast<float>(levels_[first_level_[image]].height); }

    /// Linear colour and alpha at texture coordinates (v downwards, repeated beyond [0, 1]), trilinear: bilinear in the
    /// two levels about `level_of_detail` (0: the image itself), mixed. |coordinates| below 2^20.
    Four sample(std::size_t image, float u, float v, float level_of_detail) const;

  private:
    Four bilinear(const TextureLevel& level, float u, float v) const;
    Four texel(const TextureLevel& level, int x, int y) const {
        return unpacked(texels_[level.first + static_cast<std::size_t>(y * level.width + x)]);
    }

    std::vector<PackedFour> texels_;
    std::vector<TextureLevel> levels_;     ///< of all images, each from itself down to one texel
    std::vector<std::size_t> first_level_; ///< of each image, and one more for the end
};

/// Largest integer not above x, as far as an int reaches; without a library call.
inline int floor_of_lane(float x) {
    const int truncated = static_cast<int>(x);
    return truncated - (static_cast<float>(truncated) > x ? 1 : 0);
}

inline Four TexturePool::bilinear(const TextureLevel& level, float u, float v) const {
    const float x = u * static_cast<float>(level.width) - 0.5f;
    const float y = v * static_cast<float>(level.height) - 0.5f;
    const int column = floor_of_lane(x);
    const int row = floor_of_lane(y);
    const float right_share = x - static_cast<float>(column);
    const float lower_share = y - static_cast<float>(row);
    // u and v lie in [0, 1]: at most one step beyond either edge.
    const int left = column < 0 ? level.width - 1 : (column >= level.width ? 0 : column);
    const int right = column + 1 >= level.width ? 0 : column + 1;
    const int upper = row < 0 ? level.height - 1 : (row >= level.height ? 0 : row);
    const int lower = row + 1 >= level.height ? 0 : row + 1;
    const Four a = texel(level, left, upper);
    const Four b = texel(level, right, upper);
    const Four c = texel(level, left, lower);
    const Four d = texel(level, right, lower);
    const Four above = a + right_share * (b - a);
    const Four below = c + right_share * (d - c);
    return above + lower_share * (below - above);
}

inline Four TexturePool::sample(std::size_t image, float u, float v, float level_of_detail) const {
    constexpr float per_step = 1.0f / 65535.0f;
    const TextureLevel* const levels = &levels_[first_level_[image]];
    const float within_u = u - static_cast<float>(floor_of_lane(u));
    const float within_v = v - static_cast<float>(floor_of_lane(v));
    const auto last = static_cast<float>(first_level_[image + 1] - first_level_[image] - 1);
    const float level = level_of_detail > 0.0f ? (level_of_detail < last ? level_of_detail : last) : 0.0f;
    const auto finer = static_cast<std::size_t>(level);
    const float coarser_share = level - static_cast<float>(finer);
    const Four fine = bilinear(levels[finer], within_u, within_v);
    if (coarser_share == 0.0f) {
        return per_step * fine;
    }
    const Four coarse = bilinear(levels[finer + 1], within_u, within_v);
    return per_step * (fine + coarser_share * (coarse - fine));
}

} // namespace render

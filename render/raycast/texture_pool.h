#pragma once

#include "content/scene_desc.h"
#include "render/raycast/lanes.h"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace render {

using PackedFour = std::array<std::uint16_t, 4>;

/// The four integers as floats.
inline Four unpacked(const PackedFour& packed) {
    using Halves [[gnu::vector_size(16)]] = std::uint16_t;
    using Words [[gnu::vector_size(16)]] = std::int32_t;
    using Pair [[gnu::vector_size(16)]] = std::uint64_t;
    static_assert(std::endian::native == std::endian::little);
    const auto low = reinterpret_cast<Halves>(Pair{std::bit_cast<std::uint64_t>(packed), 0});
    const auto widened = __builtin_shufflevector(low, Halves{}, 0, 8, 1, 9, 2, 10, 3, 11);
    return __builtin_convertvector(reinterpret_cast<Words>(widened), Four);
}

/// One level of an image's mipmaps.
struct TextureLevel {
    std::uint32_t first = 0; ///< texel in TexturePool
    int width = 1;
    int height = 1;
};

/// Which images sixteen lanes look at, where (v downwards, repeated beyond [0, 1], below 2^20 in size) and how finely:
/// level 0 is the image itself.
struct TextureLookUp {
    LaneIndices image;
    Lanes u;
    Lanes v;
    Lanes level;
};

/// A scene's images with mipmaps, decoded from sRGB so that filtering adds light: 8 bytes a texel, 16 bits a channel of
/// linear colour and alpha, a third more for the mipmaps.
class TexturePool {
  public:
    explicit TexturePool(const std::vector<content::Image>& images);

    float width(std::size_t image) const { return static_cast<float>(levels_[first_level_[image]].width); }
    float height(std::size_t image) const { return static_cast<float>(levels_[first_level_[image]].height); }

    /// Linear colour and alpha in the wanted lanes, trilinear: bilinear in the two levels about the one asked for,
    /// mixed.
    void sample(const TextureLookUp& look_up, LaneMask wanted, std::array<Four, lane_count>& colours) const;

  private:
    std::vector<PackedFour> texels_;
    std::vector<TextureLevel> levels_;       ///< of all images, each from itself down to one texel
    std::vector<std::uint32_t> first_level_; ///< of each image, and one more for the end
};

} // namespace render

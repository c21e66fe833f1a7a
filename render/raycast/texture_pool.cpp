#include "render/raycast/texture_pool.h"

#include "content/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>

namespace render {
namespace {

void add_levels(const content::Image& image, std::size_t& texels, std::vector<TextureLevel>& levels) {
    for (int width = image.width, height = image.height;;
         width = std::max(width / 2, 1), height = std::max(height / 2, 1)) {
        levels.push_back({texels, width, height});
        texels += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
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

} // namespace

TexturePool::TexturePool(const std::vector<content::Image>& images) {
    std::size_t texels = 0;
    for (const content::Image& image : images) {
        first_level_.push_back(levels_.size());
        add_levels(image, texels, levels_);
    }
    first_level_.push_back(levels_.size());
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

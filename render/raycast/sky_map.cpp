#include "render/raycast/sky_map.h"

#include "render/cube_face.h"
#include "render/panorama.h"

#include <glm/common.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <tbb/parallel_for.h>

namespace render {
namespace {

PackedFour packed(const glm::vec3& radiance) {
    const glm::vec3 light = glm::max(radiance, glm::vec3(0.0f));
    const float largest = std::max({light.x, light.y, light.z, 1e-30f});
    int exponent = 0;
    std::frexp(largest, &exponent); // largest < 2^exponent
    const float scale = std::ldexp(65535.0f, -exponent);
    const glm::vec3 mantissa = scale * light + 0.5f;
    return PackedFour{static_cast<std::uint16_t>(mantissa.x), static_cast<std::uint16_t>(mantissa.y),
                      static_cast<std::uint16_t>(mantissa.z), static_cast<std::uint16_t>(exponent + 127)};
}

} // namespace

SkyMap::SkyMap(const content::Panorama& panorama) : size_(cube_face_size(panorama)) {
    std::size_t texels = 0;
    for (int size = size_;; size /= 2) {
        levels_.push_back({size, texels});
        texels += 6 * (static_cast<std::size_t>(size) + 2) * (static_cast<std::size_t>(size) + 2);
        if (size % 2 != 0) {
            break; // a few degrees a texel
        }
    }
    texels_.resize(texels);
    fill(panorama);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        if (i > 0) {
            halve(levels_[i - 1], levels_[i]);
        }
        fill_borders(levels_[i]);
    }
}

void SkyMap::fill(const content::Panorama& panorama) {
    const Level& level = levels_.front();
    tbb::parallel_for(0, 6 * size_, [&](int row) {
        const int face = row / size_;
        const int y = row % size_;
        for (int x = 0; x < size_; ++x) {
            const glm::dvec3 direction =
                direction_from_face(face, (2.0 * x + 1.0) / size_ - 1.0, (2.0 * y + 1.0) / size_ - 1.0);
            texels_[level.on_face(face, x, y)] = packed(glm::vec3(panorama_radiance(panorama, direction)));
        }
    });
}

void SkyMap::halve(const Level& fine, const Level& coarse) {
    tbb::parallel_for(0, 6 * coarse.size, [&](int row) {
        const int face = row / coarse.size;
        const int y = row % coarse.size;
        for (int x = 0; x < coarse.size; ++x) {
            glm::vec3 sum(0.0f);
            for (int corner = 0; corner < 4; ++corner) {
                sum += texel(fine.on_face(face, 2 * x + (corner & 1), 2 * y + (corner >> 1)));
            }
            texels_[coarse.on_face(face, x, y)] = packed(0.25f * sum);
        }
    });
}

void SkyMap::fill_borders(const Level& level) {
    const auto neighbour = [&](int face, int x, int y) {
        const double size = level.size;
        const CubePlace place = cube_place(
            glm::vec3(direction_from_face(face, (2.0 * x + 1.0) / size - 1.0, (2.0 * y + 1.0) / size - 1.0)));
        // Between the texels that the neighbour has of its own.
        const auto inside = [&](float coordinate) {
            const float reach = 1.0f - 1.001f / static_cast<float>(level.size);
            return std::clamp(coordinate, -reach, reach);
        };
        texels_[level.on_face(face, x, y)] = packed(bilinear(level, place.face, inside(place.s), inside(place.t)));
    };
    for (int face = 0; face < 6; ++face) {
        for (int i = -1; i <= level.size; ++i) {
            neighbour(face, i, -1);
            neighbour(face, i, level.size);
            neighbour(face, -1, i);
            neighbour(face, level.size, i);
        }
    }
}

glm::vec3 SkyMap::texel(std::size_t at) const {
    const PackedFour& packed_texel = texels_[at];
    const float scale = std::bit_cast<float>(static_cast<std::uint32_t>(packed_texel[3]) << 23) * (1.0f / 65535.0f);
    const Four mantissas = unpacked(packed_texel);
    return scale * glm::vec3(mantissas[0], mantissas[1], mantissas[2]);
}

glm::vec3 SkyMap::bilinear(const Level& level, int face, float s, float t) const {
    const float x = 0.5f * (s + 1.0f) * static_cast<float>(level.size) - 0.5f;
    const float y = 0.5f * (t + 1.0f) * static_cast<float>(level.size) - 0.5f;
    const int left = std::clamp(floor_of_lane(x), -1, level.size - 1);
    const int top = std::clamp(floor_of_lane(y), -1, level.size - 1);
    const float right_share = x - static_cast<float>(left);
    const float lower_share = y - static_cast<float>(top);
    const std::size_t at = level.on_face(face, left, top);
    const std::size_t below = level.on_face(face, left, top + 1);
    const glm::vec3 upper = glm::mix(texel(at), texel(at + 1), right_share);
    const glm::vec3 lower = glm::mix(texel(below), texel(below + 1), right_share);
    return glm::mix(upper, lower, lower_share);
}

glm::vec3 SkyMap::radiance(const glm::vec3& direction, float level_of_detail) const {
    const CubePlace place = cube_place(direction);
    const float level = std::clamp(level_of_detail, 0.0f, static_cast<float>(levels_.size() - 1));
    const auto finer = static_cast<std::size_t>(level);
    const float coarser_share = level - static_cast<float>(finer);
    const glm::vec3 fine = bilinear(levels_[finer], place.face, place.s, place.t);
    if (coarser_share == 0.0f) {
        return fine;
    }
    return glm::mix(fine, bilinear(levels_[finer + 1], place.face, place.s, place.t), coarser_share);
}

} // namespace render

#pragma once

#include "content/scene_desc.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace render {

/// Direction of face `face` (GL order: +x, -x, +y, -y, +z, -z) at face coordinates in [-1, 1]; OpenGL 4.5 table 8.19.
/// Unit. Coordinates may go beyond a face, along its plane.
inline glm::dvec3 direction_from_face(int face, double s, double t) {
    const std::array<glm::dvec3, 6> directions{glm::dvec3(1.0, -t, -s), {-1.0, -t, s}, {s, 1.0, t},
                                               {s, -1.0, -t},           {s, -t, 1.0},  {-s, -t, -1.0}};
    return glm::normalize(directions[static_cast<std::size_t>(face)]);
}

struct CubePlace {
    int face = 0;
    float s = 0.0f;
    float t = 0.0f;
};

/// The inverse: the face that a direction meets, and where.
inline CubePlace cube_place(const glm::vec3& direction) {
    const glm::vec3 size(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
    if (size.x >= size.y && size.x >= size.z) {
        const float scale = 1.0f / size.x;
        return direction.x >= 0.0f ? CubePlace{0, -direction.z * scale, -direction.y * scale}
                                   : CubePlace{1, direction.z * scale, -direction.y * scale};
    }
    if (size.y >= size.z) {
        const float scale = 1.0f / size.y;
        return direction.y >= 0.0f ? CubePlace{2, direction.x * scale, direction.z * scale}
                                   : CubePlace{3, direction.x * scale, -direction.z * scale};
    }
    const float scale = 1.0f / size.z;
    return direction.z >= 0.0f ? CubePlace{4, direction.x * scale, -direction.y * scale}
                               : CubePlace{5, -direction.x * scale, -direction.y * scale};
}

/// Texels along a face that keep a panorama's sharpness: 2/pi of its height, a multiple of 64.
inline int cube_face_size(const content::Panorama& panorama) {
    const double size = 2.0 * std::numbers::inv_pi * panorama.height;
    return std::clamp(64 * static_cast<int>(std::ceil(size / 64.0)), 64, 4096);
}

} // namespace render

#include "render/raycast/packet_rays.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace render {
namespace warp_shader {
using glm::dot;
using glm::vec2;
using glm::vec3;
#include "render/shaders/shared/warp.glsl"
} // namespace warp_shader

RAPIDITY_VECTOR_CLONES
void see_packet(const ScreenRays& screen, int left, int bottom, SeenPacket& seen) {
    const ScreenRays s = screen; // for the compiler: what is written below does not change it
    const glm::mat3 world_from_axis = screen.world_from_axis;
    const glm::vec3 first =
        s.origin + (static_cast<float>(left) + 0.5f) * s.right + (static_cast<float>(bottom) + 0.5f) * s.up;
    for (int i = 0; i < lane_count; ++i) {
        const auto column = static_cast<float>(i & 3);
        const auto row = static_cast<float>(i >> 2);
        const glm::vec3 ray(first.x + column * s.right.x + row * s.up.x, first.y + column * s.right.y + row * s.up.y,
                            first.z + column * s.right.z + row * s.up.z);
        const float length2 = ray.x * ray.x + ray.y * ray.y + ray.z * ray.z;
        const warp_shader::SeenLight light =
            warp_shader::see_along_z((1.0f / std::sqrt(length2)) * ray, s.exp_rapidity);
        const glm::vec3 n = (1.0f / light.wavelength_ratio) * light.direction_times_ratio;
        const glm::mat3& m = world_from_axis;
        seen.direction.x[i] = m[0].x * n.x + m[1].x * n.y + m[2].x * n.z;
        seen.direction.y[i] = m[0].y * n.x + m[1].y * n.y + m[2].y * n.z;
        seen.direction.z[i] = m[0].z * n.x + m[1].z * n.y + m[2].z * n.z;
        seen.wavelength_ratio[i] = light.wavelength_ratio;
        seen.ray_length2[i] = length2;
    }
}

RAPIDITY_VECTOR_CLONES
void spread_of(const SeenPacket& seen, float focal_pixels, Lanes& spread) {
    for (int i = 0; i < lane_count; ++i) {
        const float length = std::sqrt(seen.ray_length2[i]);
        spread[i] = 1.0f / (focal_pixels * length * std::sqrt(length) * seen.wavelength_ratio[i]);
    }
}

RAPIDITY_VECTOR_CLONES
LaneMask lanes_with_hits(const PacketHits& hits) {
    LaneMask found = 0;
    for (int i = 0; i < lane_count; ++i) {
        found |= (hits.instance[i] != PacketHits::nothing ? 1u : 0u) << static_cast<unsigned>(i);
    }
    return found;
}

} // namespace render

#include "render/raycast/packet_colour.h"

#include "render/raycast/texture_pool.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>

namespace render {
namespace light_shader {
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::max;
using glm::mix;
using glm::vec2;
using glm::vec3;
inline float log2(float x) {
    return log2_of_lane(x);
}
#include "render/shaders/shared/colour.glsl"
#include "render/shaders/shared/sky_gradient.glsl"
#include "render/shaders/shared/sky_lod.glsl"
} // namespace light_shader

RAPIDITY_VECTOR_CLONES
void add_gradient_sky(const content::GradientSky& sky, const SeenPacket& seen, LaneMask wanted, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 radiance =
            light_shader::gradient_sky_radiance(seen.direction.y[i], sky.zenith, sky.horizon, sky.nadir);
        const bool take = ((wanted >> static_cast<unsigned>(i)) & 1u) != 0;
        light.x[i] = take ? radiance.x : light.x[i];
        light.y[i] = take ? radiance.y : light.y[i];
        light.z[i] = take ? radiance.z : light.z[i];
    }
}

RAPIDITY_VECTOR_CLONES
void sky_levels(float texels_per_pixel, const SeenPacket& seen, Lanes& levels) {
    for (int i = 0; i < lane_count; ++i) {
        levels[i] = light_shader::sky_lod(texels_per_pixel, seen.wavelength_ratio[i],
                                          glm::vec3(std::sqrt(seen.ray_length2[i]), 0.0f, 0.0f));
    }
}

RAPIDITY_VECTOR_CLONES
void pack_halves(const Lanes3& light, LaneMask sky, std::array<HalfPixel, lane_count>& halves) {
    constexpr std::uint16_t one = 0x3c00;
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 kept = light_shader::within_half_range(glm::vec3(light.x[i], light.y[i], light.z[i]));
        halves[static_cast<std::size_t>(i)] = {half_of_lane(kept.x), half_of_lane(kept.y), half_of_lane(kept.z),
                                               ((sky >> static_cast<unsigned>(i)) & 1u) != 0 ? one : std::uint16_t{0}};
    }
}

} // namespace render

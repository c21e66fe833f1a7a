#pragma once

#include "render/raycast/cast_scenery.h"
#include "render/raycast/lanes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <array>
#include <limits>

namespace render {

/// What a packet's hits are made of, lane by lane.
struct Surfaces {
    Lanes3 position;
    Lanes3 facing; ///< unit normal of the triangle, towards the eye
    Lanes3 normal; ///< unit shading normal, towards the eye
    Lanes3 reflectance;
    Lanes3 emission;
    Lanes s; ///< texture coordinates
    Lanes t;
    Lanes3 gradient_s;
    Lanes3 gradient_t;
    std::array<const CastMaterial*, lane_count> materials{};
    LaneMask emitting = 0;
    LaneMask lit = 0; ///< not unlit
    LaneMask textured = 0;
    LaneMask emission_textured = 0;
};

/// The box that the wanted positions lie in.
struct PacketBox {
    PacketBox(const Surfaces& surfaces, LaneMask wanted) {
        for (int i = 0; i < lane_count; ++i) {
            if (has(wanted, i)) {
                const glm::vec3 position(surfaces.position.x[i], surfaces.position.y[i], surfaces.position.z[i]);
                low = glm::min(low, position);
                high = glm::max(high, position);
            }
        }
    }
    bool within(float range, const glm::vec3& point) const {
        const glm::vec3 apart = glm::max(glm::max(low - point, point - high), glm::vec3(0.0f));
        return glm::dot(apart, apart) < range * range;
    }
    glm::vec3 low{std::numeric_limits<float>::max()};
    glm::vec3 high{std::numeric_limits<float>::lowest()};
};

} // namespace render

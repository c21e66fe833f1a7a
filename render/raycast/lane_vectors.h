#pragma once

#include "render/raycast/lanes.h"

#include <glm/vec3.hpp>

/// Vectors of single lanes.
namespace render {

inline glm::vec3 lane_of(const Lanes3& lanes, int lane) {
    return {lanes.x[lane], lanes.y[lane], lanes.z[lane]};
}

inline void set_lane(Lanes3& lanes, int lane, const glm::vec3& value) {
    lanes.x[lane] = value.x;
    lanes.y[lane] = value.y;
    lanes.z[lane] = value.z;
}

} // namespace render

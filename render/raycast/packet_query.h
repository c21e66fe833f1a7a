#pragma once

#include "render/offline/embree.h"
#include "render/raycast/lanes.h"

namespace render {

/// A packet's query of what its rays from `origin` meet first, each up to `limit`: the same unit as origin.
inline RTCRayHit16 rays_from(const glm::vec3& origin, const Lanes3& directions, const Lanes& limit) {
    RTCRayHit16 query;
    for (int i = 0; i < lane_count; ++i) {
        query.ray.org_x[i] = origin.x;
        query.ray.org_y[i] = origin.y;
        query.ray.org_z[i] = origin.z;
        query.ray.dir_x[i] = directions.x[i];
        query.ray.dir_y[i] = directions.y[i];
        query.ray.dir_z[i] = directions.z[i];
        query.ray.tnear[i] = 0.0f;
        query.ray.tfar[i] = limit[i];
        query.ray.time[i] = 0.0f;
        query.ray.mask[i] = ~0u;
        query.ray.flags[i] = 0;
        query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    return query;
}

/// Where every ray of a packet is asked about.
struct alignas(64) AllValid {
    std::array<int, lane_count> lanes;
    constexpr AllValid() : lanes() { lanes.fill(-1); }
};
inline constexpr AllValid all_valid;

} // namespace render

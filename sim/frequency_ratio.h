#pragma once

#include "sim/four_vector.h"

namespace sim {

/// Frequency of light that comes from a direction of the world, to whoever moves with a four-velocity u, over its
/// frequency in the world: u.t + n.u, without cancellation. For a source it is lambda_world / lambda_source.
inline double frequency_ratio(const FourVector<World>& u, const Direction<World>& from) {
    const glm::dvec3& n = from.unit;
    const double along = n.x * u.space.x + n.y * u.space.y + n.z * u.space.z;
    if (along >= 0.0) {
        return u.t + along;
    }
    // (t + a)(t - a) = 1 + |u|^2 - a^2, whose last two are the square of what lies across the ray.
    const glm::dvec3 across(u.space.y * n.z - u.space.z * n.y, u.space.z * n.x - u.space.x * n.z,
                            u.space.x * n.y - u.space.y * n.x);
    return (1.0 + across.x * across.x + across.y * across.y + across.z * across.z) / (u.t - along);
}

} // namespace sim

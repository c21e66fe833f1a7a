#include "sim/sky_cap.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sim {

SkyCap<Head> where_seen(const BoostAndRotation& eye, const SkyCap<World>& cap) {
    const glm::dvec3& c = cap.axis.unit;
    const double along = glm::dot(c, eye.along);
    const double cos_half = std::cos(cap.half_angle.value);
    const double growing = 0.5 * std::exp(eye.xi.value) * (cos_half + along);
    const double shrinking = 0.5 * std::exp(-eye.xi.value) * (cos_half - along);
    const glm::dvec3 axis = c - eye.along * along + eye.along * (growing - shrinking);
    // From the invariant length: acos of the ratio of growing + shrinking to |axis| would cancel for small caps.
    const double half_angle = std::atan2(std::sin(cap.half_angle.value), growing + shrinking);
    return {{glm::transpose(eye.boosted_from_head) * glm::normalize(axis)}, Radians(half_angle)};
}

} // namespace sim

#include "sim/retarded.h"

#include <glm/geometric.hpp>

namespace sim {

Emission retarded_emission(const InertialObject& object, const Event& eye) {
    const glm::dvec3& v = object.velocity;
    const glm::dvec3 r = object.position_at_zero + eye.t * v - eye.space;
    const double speed = glm::length(v);
    const double along = glm::dot(v, r);
    const double inverse_gamma2 = (1.0 - speed) * (1.0 + speed);
    const double distance2 = glm::dot(r, r);
    const double root = std::sqrt(along * along + inverse_gamma2 * distance2);
    // The same root of the quadratic in the form that does not cancel.
    const double delay = along > 0.0 ? distance2 / (along + root) : (root - along) / inverse_gamma2;

    Emission seen;
    seen.event = {eye.t - delay, object.position_at_zero + (eye.t - delay) * v};
    if (delay > 0.0) {
        seen.from.unit = glm::normalize(r - delay * v);
    }
    seen.wavelength_ratio = 1.0 / where_seen(boosted_eye(v), seen.from).wavelength_ratio;
    return seen;
}

} // namespace sim

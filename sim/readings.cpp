#include "sim/readings.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace sim {

Readings readings(const VehicleState& state) {
    const glm::dquat facing_ahead(1.0, 0.0, 0.0, 0.0);
    const BoostAndRotation eye = split(world_from_head(state.world_from_vehicle, facing_ahead));
    const double xi = eye.xi.value;

    Readings result;
    result.rapidity = eye.xi;
    result.beta = std::tanh(xi);
    result.one_minus_beta = 2.0 / (std::exp(2.0 * xi) + 1.0);
    result.gamma = std::cosh(xi);
    result.gamma_minus_one = 2.0 * std::pow(std::sinh(0.5 * xi), 2.0);
    if (xi > 0.0) {
        result.motion_in_world = eye.along;
        result.motion_in_vehicle = glm::transpose(eye.boosted_from_head) * eye.along;
    }
    result.wavelength_ratio_ahead = see(eye, Direction<Head>{{0.0, 0.0, -1.0}}).wavelength_ratio;
    result.wavelength_ratio_along_motion = std::exp(-xi);
    const glm::dvec3& a = state.felt_acceleration;
    result.felt_acceleration = std::hypot(a.x, a.y, a.z);
    return result;
}

} // namespace sim

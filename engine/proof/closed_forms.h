#pragma once

#include "sim/four_vector.h"

#include <glm/vec3.hpp>

#include <cmath>

/// Motions that are known in closed form, to hold the integrator's against.
namespace engine {

/// From rest, after ship time tau at constant proper acceleration a > 0 along the unit vector `along`:
/// t = sinh(a tau)/a, x = (cosh(a tau) - 1)/a.
inline sim::Event hyperbolic_motion(double a, double tau, const glm::dvec3& along) {
    const double half = std::sinh(0.5 * a * tau);
    return {std::sinh(a * tau) / a, (2.0 * half * half / a) * along};
}

/// A circle at constant speed: what a ship feels whose axes turn once a revolution, so that its x axis stays along its
/// motion and its y axis points to the centre.
struct CircularMotion {
    double beta;          ///< speed, > 0
    double angular_speed; ///< Omega, radians of the revolution per world time, > 0

    double gamma() const { return 1.0 / std::sqrt((1.0 - beta) * (1.0 + beta)); }
    /// Towards the centre.
    double proper_acceleration() const { return gamma() * gamma() * angular_speed * beta; }
    /// Of the axes against gyroscopes, about z: gamma^2 Omega, by which a revolution of ship time 2 pi/(gamma Omega)
    /// turns them by 2 pi gamma. Gyroscopes so turn back by 2 pi (gamma - 1) a revolution (Thomas 1926).
    double proper_turn_rate() const { return gamma() * gamma() * angular_speed; }
    double world_period() const { return 2.0 * 3.14159265358979323846 / angular_speed; }
    double ship_period() const { return world_period() / gamma(); }
};

/// Angle by which two boosts in a row, of rapidities xi_1 and xi_2 at an angle theta, turn a body (Thomas, Wigner):
/// tan(angle/2) = sin theta / (cos theta + coth(xi_1/2) coth(xi_2/2)).
inline double thomas_wigner_angle(double xi_1, double xi_2, double theta) {
    const double product = std::tanh(0.5 * xi_1) * std::tanh(0.5 * xi_2);
    return 2.0 * std::atan2(product * std::sin(theta), 1.0 + product * std::cos(theta));
}

} // namespace engine

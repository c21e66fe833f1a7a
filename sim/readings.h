#pragma once

#include "sim/vehicle.h"

#include <glm/vec3.hpp>

/// What a ship's instruments show.
namespace sim {

/// Instruments of one state. Every value keeps its full relative precision at any speed.
struct Readings {
    double beta = 0.0;           ///< speed in the world
    double one_minus_beta = 1.0; ///< 2 / (e^(2 xi) + 1), for speeds whose beta reads 1
    double gamma = 1.0;
    double gamma_minus_one = 0.0; ///< 2 sinh^2(xi/2), for speeds whose gamma reads 1
    Rapidity rapidity;
    glm::dvec3 motion_in_world{0.0};     ///< unit vector of the velocity, world axes; zero at rest
    glm::dvec3 motion_in_vehicle{0.0};   ///< the same carried over by the boost, vehicle axes; zero at rest
    double wavelength_ratio_ahead = 1.0; ///< D of light from straight ahead of the nose
    double wavelength_ratio_along_motion =
        1.0;                        ///< D = e^-xi of light from where the ship is going: the smallest there is
    double felt_acceleration = 0.0; ///< magnitude, c per clock unit
};

Readings readings(const VehicleState& state);

} // namespace sim

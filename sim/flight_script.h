#pragma once

#include "sim/quantities.h"
#include "sim/vehicle.h"

#include <vector>

namespace sim {

/// A part of a flight written down beforehand: constant thrust and turn.
struct FlightSegment {
    ProperTime duration;              ///< clock units of ship time, > 0
    glm::dvec3 proper_acceleration{}; ///< vehicle axes, c per clock unit
    glm::dvec3 angular_velocity{};    ///< vehicle axes, radians per clock unit
};

using FlightScript = std::vector<FlightSegment>;

/// Steps that a segment takes at `rate` steps per clock unit: the smallest whole number that makes none longer than
/// 1 / rate.
double steps_of_segment(const FlightSegment& segment, double rate);

/// Flies one segment for exactly its duration, in equal steps of duration / steps_of_segment; where the duration is a
/// whole number of ticks these are the ticks of a piloted flight. No limits apply. `stepper` takes each step: `step`,
/// or `exact_step`.
VehicleState fly_segment(const VehicleState& before, const FlightSegment& segment, double rate,
                         VehicleState (*stepper)(const VehicleState&, ProperTime, const Drive&) = step);

} // namespace sim

#pragma once

#include "sim/quantities.h"

#include <glm/vec3.hpp>

#include <vector>

namespace sim {

/// A flight written down beforehand: constant thrust and turn, one row after the other (c = 1, vehicle axes).
struct FlightSegment {
    ProperTime duration;              ///< clock units of ship time, > 0
    glm::dvec3 proper_acceleration{}; ///< c per clock unit
    glm::dvec3 angular_velocity{};    ///< radians per clock unit
};

using FlightScript = std::vector<FlightSegment>;

} // namespace sim

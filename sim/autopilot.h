#pragma once

#include "sim/vehicle.h"

#include <string_view>

/// Flies to the target and comes to rest there: a trip of two burns (trip.h), planned again every tick of the first
/// from where the ship is. The second burn brakes with what stops it at the target, (cosh xi - 1) / distance, and
/// steers across by what is left of the thrust; the last ticks are solved exactly, as a double integrator.
namespace sim {

/// What the autopilot does during one tick.
struct AutopilotTick {
    glm::dvec3 proper_acceleration{0.0}; ///< vehicle axes, within the thrust counted on
    glm::dvec3 angular_velocity{0.0};    ///< vehicle axes, before the limits
    Guidance guidance;                   ///< after the tick
};

/// One tick; guidance.phase is one that flies, or `off` to begin.
AutopilotTick fly_autopilot(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control);

/// For people: "accelerating", "arrived at rest", ...
std::string_view phase_name(AutopilotPhase phase);

} // namespace sim

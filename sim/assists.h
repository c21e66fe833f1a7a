#pragma once

#include "sim/vehicle.h"

/// From what the pilot demands to what the ship does: dampers, holding a heading, pointing, braking, cruising, and the
/// autopilot; within the limits of thrust, turn and propellant. A recording keeps the demands, not what follows from
/// them, so a year on autopilot takes no more room than a second.
namespace sim {

/// What the ship does during one tick, and what it remembers of it.
struct AssistedDrive {
    Drive drive;
    Rapidity rapidity_spent; ///< after the tick
    Guidance guidance;       ///< after the tick
};

/// - Dampers, unless ControlFrame::undamped: an axis that nobody turns stops turning; undamped, it turns on.
/// - Pointing turns the nose where it says; hands that turn the ship go before it, but for hold_heading.
/// - brake thrusts against the motion, as much as the limits allow and just what is missing in the last tick; at rest
///   not at all. An unlimited vehicle brakes with 1 c per clock unit.
/// - cruise thrusts along the motion (at rest: ahead) to hold Guidance::cruise; hands thrust across it.
/// - autopilot, while it flies, turns and thrusts alone. brake ends it for as long as it is held.
AssistedDrive assisted_drive(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control);

} // namespace sim

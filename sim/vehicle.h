#pragma once

#include "sim/control_frame.h"
#include "sim/lorentz.h"
#include "sim/quantities.h"

#include <limits>

namespace sim {

/// What a vehicle can do. Fixed during a flight; not part of the state.
struct VehicleSettings {
    /// Largest proper acceleration, c per clock unit, per vehicle axis pair; > 0.
    glm::dvec3 maximum_acceleration{std::numeric_limits<double>::infinity()};
    /// Largest turn rate, radians per clock unit, about each vehicle axis; > 0.
    glm::dvec3 maximum_turn_rate{std::numeric_limits<double>::infinity()};
    /// Factor on maximum_acceleration while boost is held; >= 1.
    double boost_factor = 4.0;
    /// Fixed steps per clock unit of ship time; > 0.
    double tick_rate = 240.0;
};

/// Everything that evolves. Saved, hashed and restored; equal states fly equal flights, bit for bit.
struct VehicleState {
    Tick tick = 0;
    ProperTime ship_clock; ///< tau
    Event event;           ///< where and when the ship is, in the world
    Lorentz<World, Vehicle> world_from_vehicle;
    glm::dvec3 felt_acceleration{0.0}; ///< what the pilot felt during the last tick, vehicle axes, c per clock unit
    glm::dvec3 angular_velocity{0.0};  ///< during the last tick, vehicle axes, radians per clock unit
};

/// Advances the ship by one fixed step of proper time under what the pilot demands, within the vehicle's limits:
/// dx/dtau = u, dLambda/dtau = 1/2 Lambda (a - i w).sigma (PHYSICS 3), RK4, then the smallest correction to det = 1.
VehicleState advance(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control);

/// The eyes' frame at rest in the vehicle: world_from_vehicle times the head's rotation.
Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle,
                                     const glm::dquat& vehicle_from_head);

/// The eyes' event: ship event + Lambda (0, head position). Exact to order (acceleration times offset).
Event head_event(const VehicleState& state, const glm::dvec3& head_position);

} // namespace sim

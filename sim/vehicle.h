#pragma once

#include "sim/control_frame.h"
#include "sim/equation_of_motion.h"
#include "sim/far_event.h"
#include "sim/guidance.h"
#include "sim/lorentz.h"
#include "sim/quantities.h"

#include <limits>

/// Motion of a ship that is steered by constant thrust and turn during each fixed step:
/// dx/dtau = u, dLambda/dtau = 1/2 Lambda (a - i w).sigma, by RK4, then the smallest correction to det = 1.
/// Gravity-free. RK4 gives the changes of x and Lambda during the step, which are added up without loss: a thrust too
/// small to change the last digit of Lambda still adds up, and millions of ticks do not drift by their roundings.
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
    /// How fast a turn rate can change, radians per clock unit squared, about each vehicle axis; > 0.
    glm::dvec3 maximum_turn_acceleration{std::numeric_limits<double>::infinity()};
    /// Mass of the propellant at the start in masses of the ship without it; >= 0. Infinite: never spent.
    double propellant = std::numeric_limits<double>::infinity();
    /// Speed at which the propellant leaves the ship, c = 1; in (0, 1]. 1 is a photon rocket.
    double exhaust_speed = 1.0;
};

/// Everything that evolves. Saved, hashed and restored; equal states fly equal flights, bit for bit.
struct VehicleState {
    Tick tick = 0;
    ProperTime ship_clock; ///< tau
    Event event;           ///< where and when the ship is, in the world: the nearest double
    Event event_offset;    ///< from `event` to just where it is; what matters of it only shows far away (far_event.h)
    Lorentz<World, Vehicle> world_from_vehicle; ///< the nearest doubles
    SpinMatrix spin_remainder =
        SpinMatrix::zero();            ///< what the roundings of world_from_vehicle have left (exact_sum.h)
    glm::dvec3 felt_acceleration{0.0}; ///< what the pilot felt during the last tick, vehicle axes, c per clock unit
    glm::dvec3 angular_velocity{0.0};  ///< during the last tick, vehicle axes, radians per clock unit
    Rapidity rapidity_spent;           ///< integral of |proper acceleration| over the ship's clock (propellant.h)
    Guidance guidance;
};

/// Beyond this a flight is stopped rather than continued into the end of the range of doubles (e^700).
inline constexpr Rapidity largest_rapidity{300.0};

/// Whether a flight can go on from a state: it is no faster than largest_rapidity, and nothing in it is infinite or
/// NaN.
bool is_in_range(const VehicleState& state);

/// Advances the ship by one tick of 1 / tick_rate under what the pilot demands and what assists and autopilot make of
/// it (assists.h), within the vehicle's limits and its propellant.
VehicleState advance(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control);

/// The ship at the start of a tick with this demand: turned if it is a snap turn (ControlFrame::snap_turn), else as it is.
VehicleState snap_turned(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control);

/// Advances the ship by one step of `duration` of ship time, of any length > 0, under a given drive: the integrator
/// that `advance` uses. The local error is of order (duration * |drive|)^5.
VehicleState step(const VehicleState& before, ProperTime duration, const Drive& drive);

/// The same step in closed form (exact_step.h): to a few roundings of any duration in which the rapidity changes by
/// less than about 1. RK4 flies, because it also takes what is not constant during a step, as light in curved
/// spacetimes; this is what it is measured by.
VehicleState exact_step(const VehicleState& before, ProperTime duration, const Drive& drive);

/// The eyes' frame at rest in the vehicle: world_from_vehicle times the head's rotation.
Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle,
                                     const glm::dquat& vehicle_from_head);
/// The eyes' frame of a head that moves in the vehicle: world_from_vehicle times the head's boost times its rotation.
Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle,
                                     const glm::dquat& vehicle_from_head, const glm::dvec3& head_velocity);

/// Where and when the ship is, to twice a double's digits; for displacements from places that are far from the origin.
inline FarEvent far_event(const VehicleState& state) {
    return {state.event, state.event_offset};
}

/// Puts the ship elsewhere and leaves its motion as it is.
inline void move_to(VehicleState& state, const FarEvent& place) {
    state.event = place.origin;
    state.event_offset = place.offset;
}

/// The eyes' event: ship event + Lambda (0, head position). Exact to order (acceleration times offset).
Event head_event(const VehicleState& state, const glm::dvec3& head_position);

} // namespace sim

#pragma once

#include "sim/vehicle.h"

/// Turning and thrusting within a vehicle's limits: what assists and autopilot share.
namespace sim {

/// Limits of the thrust on each axis, with boost or without.
glm::dvec3 thrust_reach(const VehicleSettings& settings, const ControlFrame& control);

/// The largest thrust along a unit vector of the vehicle that no axis' limit forbids; `unlimited` where none does.
double largest_thrust(const glm::dvec3& along, const glm::dvec3& reach, double unlimited = 1.0);

/// A demanded turn rate within the limits on rates and on their change since the last tick.
glm::dvec3 limited_turn(const VehicleState& before, const VehicleSettings& settings, const glm::dvec3& demanded);

/// The turn rate that brings the nose to `towards` (unit, vehicle axes) soon and without swinging past: as fast as
/// it can still stop there.
glm::dvec3 turn_towards(const VehicleSettings& settings, const glm::dvec3& towards);

/// The thrust to demand so that its mean over a tick in which the ship turns has the given direction at the tick's
/// start.
glm::dvec3 before_turning(const glm::dvec3& thrust, const glm::dvec3& turn, ProperTime tick);

} // namespace sim

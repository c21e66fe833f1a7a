#pragma once

#include "sim/vehicle.h"

#include <glm/gtc/quaternion.hpp>

namespace sim {

/// A roll about the ship's long axis that brings the ship's up as near the world's as a roll can: vehicle_from_seat for
/// a seat that hangs level with the horizon in a ship that rolls. The world's axes are taken as the pure boost carries
/// them to the ship: no Thomas rotation of a curved path enters. Where the nose comes within 17 degrees of straight up
/// or down a roll means nothing there; the seat then turns smoothly back into the ship, wholly at 6 degrees.
glm::dquat level_roll(const Lorentz<World, Vehicle>& world_from_vehicle);

} // namespace sim

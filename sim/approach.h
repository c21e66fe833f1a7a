#pragma once

#include "sim/vehicle.h"

/// A ship as what it flies to sees it: in the target's own rest frame, where every trip ends at rest at the origin.
namespace sim {

/// Motion of the ship in the rest frame of an inertial object, whose axes are the world's carried over by the boost.
struct Approach {
    glm::dvec3 way{0.0};            ///< from the ship to the object, at one time of the object's clock
    FourVector<Goal> four_velocity; ///< of the ship
    BoostAndRotation motion;        ///< rapidity and direction in the object's frame; rotation goal_from_vehicle
    Lorentz<Goal, Vehicle> goal_from_vehicle;
};
Approach approach(const VehicleState& state, const InertialObject& object);

/// The pure boost to an object's rest frame.
Lorentz<Goal, World> goal_from_world(const InertialObject& object);

/// An inertial object, by its light and by where it is.
struct Sighting {
    glm::dvec3 seen{0.0, 0.0, -1.0}; ///< unit, head axes: where its light comes from; arbitrary at the object
    glm::dvec3 now{0.0, 0.0, -1.0};  ///< unit, head axes: where it is at this moment of the eye's own rest frame
    double wavelength_ratio = 1.0;   ///< D of its light
    double distance = 0.0;           ///< in its own rest frame, light clock units
    double clock_seen = 0.0;         ///< what is read on its clock now, which showed 0 at world time 0; clock units
    double clock_now = 0.0;          ///< what it shows at this moment of the world
};
/// What an eye at an event sees. With r from the eye to the object in the object's rest frame, light from it comes
/// along r and left |r| ago; the place `now` is r with its part along the motion contracted by gamma.
Sighting sighting(const FarEvent& eye, const Lorentz<World, Head>& world_from_head, const InertialObject& object);

} // namespace sim

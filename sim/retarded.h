#pragma once

#include "sim/lorentz.h"

/// What is seen of an object that moves uniformly: where its world line meets the eye's past light cone.
namespace sim {

/// An object without acceleration.
struct InertialObject {
    glm::dvec3 position_at_zero{0.0}; ///< world, at t = 0, light clock units
    glm::dvec3 velocity{0.0};         ///< world, c = 1, shorter than 1
};

/// Light that reaches an event from an object.
struct Emission {
    Event event;                 ///< where and when it left the object
    Direction<World> from;       ///< where it comes from, in the world; arbitrary when the object is at the eye
    double wavelength_ratio = 1; ///< lambda_world / lambda_object along the ray
};

/// The emission from the object that is seen at `eye`, in closed form: with r the object's position at the eye's time
/// relative to the eye, the delay s solves |r - v s| = s.
Emission retarded_emission(const InertialObject& object, const Event& eye);

} // namespace sim

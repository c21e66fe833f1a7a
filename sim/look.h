#pragma once

#include "sim/lorentz.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <cmath>

namespace sim {

/// A camera's axes for a unit look direction: columns right, up, back in the frame of `look`. Up is as near +y as can
/// be; looking straight up or down it is where pitching there from -z would bring it.
inline glm::dmat3 camera_axes(const glm::dvec3& look) {
    const glm::dvec3 sideways = glm::cross(look, glm::dvec3(0.0, 1.0, 0.0));
    const double length = glm::length(sideways);
    const glm::dvec3 right = length > 1e-12 ? sideways / length : glm::dvec3(1.0, 0.0, 0.0);
    return {right, glm::cross(right, look), -look};
}

/// The rotation whose columns are the axes of `From` in `To`.
template <class To, class From>
Lorentz<To, From> rotation_to(const glm::dmat3& axes) {
    const glm::dquat turn = glm::quat_cast(axes);
    const glm::dvec3 sine(turn.x, turn.y, turn.z);
    const double length = glm::length(sine);
    const Radians angle(2.0 * std::atan2(length, turn.w));
    const glm::dvec3 axis = length > 0.0 ? sine / length : glm::dvec3(0.0, 1.0, 0.0);
    return rotation<To, From>(angle, axis);
}

/// Frame of a body that moves with rapidity xi along the unit `heading` and looks along the unit `look`, given in the
/// world's axes carried over by the pure boost.
template <class To>
Lorentz<World, To> world_from_looking(Rapidity xi, const glm::dvec3& heading, const glm::dvec3& look) {
    return boost<World, Boosted>(xi, heading) * rotation_to<Boosted, To>(camera_axes(look));
}

} // namespace sim

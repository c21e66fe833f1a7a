#include "sim/approach.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace sim {
namespace {

/// From an event to the object at the same world time, world components.
Event displacement_to(const InertialObject& object, const FarEvent& from) {
    // Summed so that an object far from the world's origin keeps its place to twice a double's digits.
    const FarEvent at_zero{{from.origin.t, object.position_at_zero}, {from.offset.t, glm::dvec3(0.0)}};
    return displacement(from, displaced(at_zero, {0.0, from.origin.t * object.velocity}));
}

/// split() knows the names World and Head; the algebra is that of any two frames.
template <class To, class From>
BoostAndRotation split_frame(const Lorentz<To, From>& frame) {
    return split(Lorentz<World, Head>{frame.spin});
}

} // namespace

Lorentz<Goal, World> goal_from_world(const InertialObject& object) {
    const double speed = glm::length(object.velocity);
    if (speed == 0.0) {
        return {};
    }
    return boost<Goal, World>(Rapidity(-std::atanh(speed)), object.velocity / speed);
}

Approach approach(const VehicleState& state, const InertialObject& object) {
    const Lorentz<Goal, World> to_goal = goal_from_world(object);
    Approach result;
    result.way = (to_goal * displacement_to(object, far_event(state))).space;
    result.goal_from_vehicle = to_goal * state.world_from_vehicle;
    result.four_velocity = four_velocity(result.goal_from_vehicle);
    result.motion = split_frame(result.goal_from_vehicle);
    return result;
}

Sighting sighting(const FarEvent& eye, const Lorentz<World, Head>& world_from_head, const InertialObject& object) {
    const Lorentz<Goal, World> to_goal = goal_from_world(object);
    const glm::dvec3 way = (to_goal * displacement_to(object, eye)).space;
    const BoostAndRotation motion = split_frame(to_goal * world_from_head);

    Sighting result;
    result.distance = glm::length(way);
    const Event since_zero = Event{eye.origin.t, eye.origin.space - object.position_at_zero} + eye.offset;
    result.clock_seen = (to_goal * since_zero).t - result.distance;
    const double speed = glm::length(object.velocity);
    result.clock_now = eye.origin.t * std::sqrt((1.0 - speed) * (1.0 + speed));
    if (result.distance > 0.0) {
        const SeenFrom seen = where_seen(motion, {way / result.distance});
        result.seen = seen.head_direction;
        result.wavelength_ratio = seen.wavelength_ratio;
        const glm::dvec3 along = motion.along * glm::dot(motion.along, way);
        const glm::dvec3 contracted = (way - along) + along / std::cosh(motion.xi.value);
        result.now = glm::transpose(motion.boosted_from_head) * glm::normalize(contracted);
    }
    return result;
}

} // namespace sim

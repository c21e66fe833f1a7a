#include "sim/steering.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace sim {

glm::dvec3 thrust_reach(const VehicleSettings& settings, const ControlFrame& control) {
    return (control.has(ControlFrame::boost) ? settings.boost_factor : 1.0) * settings.maximum_acceleration;
}

double largest_thrust(const glm::dvec3& along, const glm::dvec3& reach, double unlimited) {
    double magnitude = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (along[i] != 0.0) {
            magnitude = std::min(magnitude, reach[i] / std::abs(along[i]));
        }
    }
    return std::isinf(magnitude) ? unlimited : magnitude;
}

glm::dvec3 limited_turn(const VehicleState& before, const VehicleSettings& settings, const glm::dvec3& demanded) {
    const glm::dvec3& most = settings.maximum_turn_rate;
    const glm::dvec3 change = settings.maximum_turn_acceleration / settings.tick_rate;
    const glm::dvec3 turn = glm::clamp(demanded, -most, most);
    return glm::clamp(turn, before.angular_velocity - change, before.angular_velocity + change);
}

glm::dvec3 turn_towards(const VehicleSettings& settings, const glm::dvec3& towards) {
    const glm::dvec3 nose(0.0, 0.0, -1.0);
    const glm::dvec3 cross = glm::cross(nose, towards);
    const double sine = glm::length(cross);
    const double angle = std::atan2(sine, glm::dot(nose, towards));
    if (angle < 1e-12) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 axis = sine > 1e-9 ? cross / sine : glm::dvec3(0.0, 1.0, 0.0);
    const double tick = 1.0 / settings.tick_rate;
    const double fastest = largest_thrust(axis, settings.maximum_turn_rate, std::numeric_limits<double>::infinity());
    const double change =
        largest_thrust(axis, settings.maximum_turn_acceleration, std::numeric_limits<double>::infinity());
    // From rate w, slowing by `change` a tick, it stops within w^2 / (2 change) + w tick / 2.
    const double lost = 0.5 * change * tick;
    const double stopping = std::isinf(change) ? change : std::sqrt(lost * lost + 2.0 * change * angle) - lost;
    return axis * std::min({fastest, stopping, angle / tick});
}

glm::dvec3 before_turning(const glm::dvec3& thrust, const glm::dvec3& turn, ProperTime tick) {
    // The mean over the tick of f turned by w t is f + 1/2 T w x f + 1/6 T^2 w x (w x f); solved for f to second order.
    const glm::dvec3 once = tick.value * glm::cross(turn, thrust);
    return thrust - 0.5 * once + (tick.value / 12.0) * glm::cross(turn, once);
}

} // namespace sim

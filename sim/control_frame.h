#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace sim {

/// What the pilot demands during one tick, whoever the pilot is: keyboard, gamepad, headset, script or recording. The
/// only way anything outside steers the physics, and exactly what a recording keeps.
struct ControlFrame {
    /// Demanded proper acceleration, c per clock unit of ship time, vehicle axes. The vehicle limits it.
    glm::dvec3 proper_acceleration{0.0};
    /// Demanded angular velocity, radians per clock unit of ship time, vehicle axes. The vehicle limits it.
    glm::dvec3 angular_velocity{0.0};
    /// Head position in the vehicle, light clock units, and orientation vehicle_from_head.
    glm::dvec3 head_position{0.0};
    glm::dquat vehicle_from_head{1.0, 0.0, 0.0, 0.0};
    /// Buttons held down during this tick; bits as below.
    std::uint32_t buttons = 0;

    static constexpr std::uint32_t boost = 1u << 0u; ///< limits raised by the vehicle's boost factor
    static constexpr std::uint32_t brake = 1u << 1u; ///< thrust against the motion until at rest in the world

    friend bool operator==(const ControlFrame&, const ControlFrame&) = default;
};

} // namespace sim

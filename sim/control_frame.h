#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <cstdint>

namespace sim {

/// What the nose is turned to while nobody's hands turn it.
enum class Pointing : std::uint32_t {
    free,         ///< hands turn the ship
    hold_heading, ///< hands do not turn it: it keeps its heading against gyroscopes (Fermi-Walker transport)
    prograde,     ///< where the ship is going
    retrograde,   ///< where it comes from
    target_seen,  ///< where the target's light comes from
    target_now,   ///< where the target is now, by the ship's own clock
};

/// What the pilot demands during one tick, whoever the pilot is: keyboard, gamepad, headset, script or recording. The
/// only way anything outside steers the physics, and exactly what a recording keeps: demands, before assists and
/// autopilot, which follow from them and from the state.
struct ControlFrame {
    /// Demanded proper acceleration, c per clock unit of ship time, vehicle axes. The vehicle limits it.
    glm::dvec3 proper_acceleration{0.0};
    /// Demanded angular velocity, radians per clock unit of ship time, vehicle axes. The vehicle limits it.
    glm::dvec3 angular_velocity{0.0};
    /// Head position in the vehicle, light clock units, and orientation vehicle_from_head.
    glm::dvec3 head_position{0.0};
    glm::dquat vehicle_from_head{1.0, 0.0, 0.0, 0.0};
    /// Velocity of the head in the vehicle, c = 1, shorter than 1.
    glm::dvec3 head_velocity{0.0};
    /// Buttons and switches that are on during this tick; bits as below.
    std::uint32_t buttons = 0;

    static constexpr std::uint32_t boost = 1u << 0u;          ///< limits raised by the vehicle's boost factor
    static constexpr std::uint32_t brake = 1u << 1u;          ///< thrust against the motion until at rest
    static constexpr std::uint32_t undamped = 1u << 2u;       ///< an axis that nobody turns keeps its turn rate
    static constexpr std::uint32_t cruise = 1u << 3u;         ///< thrust along the motion holds Guidance::cruise
    static constexpr std::uint32_t autopilot = 1u << 4u;      ///< the autopilot flies to the target
    static constexpr std::uint32_t about_target = 1u << 5u;   ///< motion and rest are the target's, not the world's
    static constexpr std::uint32_t first_pointing = 1u << 6u; ///< times a Pointing; three bits
    static constexpr std::uint32_t pointing_mask = 7u * first_pointing;
    /// The ship is turned at once, at the start of the tick, by what angular_velocity would turn it in the tick, exactly
    /// and whatever the vehicle's limits; no hand turns it further in that tick. For pilots whom turning makes ill.
    static constexpr std::uint32_t snap_turn = 1u << 9u;

    bool has(std::uint32_t button) const { return (buttons & button) != 0; }
    Pointing pointing() const { return static_cast<Pointing>((buttons & pointing_mask) / first_pointing); }

    friend bool operator==(const ControlFrame&, const ControlFrame&) = default;
};

} // namespace sim

#pragma once

#include "input/bindings.h"
#include "input/pilot.h"
#include "sim/vehicle.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace input {

/// How the demand follows the hand. Times in seconds of the pilot's time.
struct PilotFeel {
    double thrust_ramp_seconds = 0.20; ///< time constant of thrust; > 0
    double turn_ramp_seconds = 0.12;   ///< time constant of turning; > 0
    double head_turn_seconds = 0.15;   ///< time constant of the view keys; > 0
    double look_per_height = 2.4;      ///< radians of head turn for a drag over the window's height
    double step_metres = 0.5;          ///< how far the head goes to a side
    double step_seconds = 0.25;        ///< time constant of that step; > 0
    double snap_at = 0.7;              ///< deflection at which a stick turns the ship by a step
    double snap_again_below = 0.3;     ///< deflection below which it is ready for the next
    StickResponse stick;
};

/// Flies by keyboard, mouse and gamepad: full deflection demands the vehicle's limit on that axis, key strokes are
/// ramped so that the picture does not jerk.
class DevicePilot final : public Pilot {
  public:
    explicit DevicePilot(const sim::VehicleSettings& vehicle, const PilotFeel& feel = {});

    /// The devices at this frame, and the actions pressed since the last, `elapsed_seconds` of the pilot's time ago.
    void sample(const DeviceState& devices, const std::vector<Action>& presses, double elapsed_seconds);
    /// Where the pilot looks now: newer than the last tick's head, for the picture, and alive while paused.
    glm::dquat vehicle_from_head() const;
    /// New limits, or another pace: how much of the pilot's time one tick takes, > 0.
    void set_vehicle(const sim::VehicleSettings& vehicle) { vehicle_ = vehicle; }
    void set_seconds_per_tick(double seconds) { seconds_per_tick_ = seconds; }

    /// Scene metres in one light clock unit: with slow light a step to the side is fast.
    void set_metres_per_light_unit(double metres) { metres_per_light_unit_ = metres; }

    /// Turns by steps: how far one goes, radians, > 0; and whether the controls that turn left and right do only that
    /// (sim::ControlFrame::snap_turn).
    void set_snap_turn(double angle, bool always) {
        snap_angle_ = angle;
        snaps_always_ = always;
    }
    /// How the seat is turned in the vehicle (sim::level_roll): hands and head are the seat's.
    void set_vehicle_from_seat(const glm::dquat& rotation) { vehicle_from_seat_ = rotation; }
    /// Head ahead and in the middle of the seat, at once.
    void recentre();

    /// Switches that are on, bits of ControlFrame; their keys turn them on and off.
    std::uint32_t switches() const { return switches_; }
    void switch_on(std::uint32_t switches) { switches_ |= switches; }
    void switch_off(std::uint32_t switches) { switches_ &= ~switches; }

    /// Never ends.
    std::optional<sim::ControlFrame> control(sim::Tick tick) override;

  private:
    void press_switches(const std::vector<Action>& presses);
    void move_head(sim::ControlFrame& frame);
    void snap(const DeviceState& devices, const std::vector<Action>& presses);
    void turn_head(const DeviceState& devices, const std::vector<Action>& presses, double elapsed_seconds);

    sim::VehicleSettings vehicle_;
    PilotFeel feel_;
    double seconds_per_tick_;
    glm::dvec3 thrust_target_{0.0}; ///< each in [-1, 1]
    glm::dvec3 turn_target_{0.0};
    glm::dvec3 thrust_{0.0};
    glm::dvec3 turn_{0.0};
    glm::dvec2 head_target_{0.0}; ///< yaw to the left and pitch up, radians
    glm::dvec2 head_{0.0};
    double step_target_ = 0.0; ///< of the head, metres to the right
    double step_ = 0.0;
    double metres_per_light_unit_ = 299792458.0;
    double snap_angle_ = 0.5235987755982988;
    bool snaps_always_ = false;
    bool ready_to_snap_ = true;
    int snaps_to_the_left_ = 0; ///< waiting for ticks; negative: to the right
    glm::dquat vehicle_from_seat_{1.0, 0.0, 0.0, 0.0};
    std::uint32_t buttons_ = 0;
    std::uint32_t switches_ = 0;
};

} // namespace input

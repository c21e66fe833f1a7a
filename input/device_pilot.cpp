#include "input/device_pilot.h"

#include "input/demand_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace input {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr double quarter_turn = 0.5 * half_turn;

/// Fraction of the way to the target after `seconds` at this time constant.
double approach(double seconds, double time_constant) {
    return 1.0 - std::exp(-seconds / time_constant);
}

/// Goes a fraction of the way, and the whole way once it no longer shows: let go, thrust ends at exactly zero.
template <class Vector>
Vector ramped(const Vector& from, const Vector& to, double fraction) {
    const Vector rest = to - from;
    return glm::length(rest) < 1e-3 ? to : from + fraction * rest;
}

/// A limit to scale with: a vehicle without a limit is flown at one c per clock unit, one radian per clock unit.
glm::dvec3 finite_limit(const glm::dvec3& limit) {
    return {std::isfinite(limit.x) ? limit.x : 1.0, std::isfinite(limit.y) ? limit.y : 1.0,
            std::isfinite(limit.z) ? limit.z : 1.0};
}

} // namespace

DevicePilot::DevicePilot(const sim::VehicleSettings& vehicle, const PilotFeel& feel)
    : vehicle_(vehicle), feel_(feel), seconds_per_tick_(1.0 / vehicle.tick_rate) {}

void DevicePilot::sample(const DeviceState& devices, const std::vector<Action>& presses, double elapsed_seconds) {
    const auto axis = [&](Action positive, Action negative) {
        return strength(devices, positive, feel_.stick) - strength(devices, negative, feel_.stick);
    };
    // Vehicle axes are a camera's: x right, y up, -z ahead. A right-handed turn about x lifts the nose, about y takes
    // it to the left, about z rolls to the left.
    thrust_target_ = {axis(Action::thrust_right, Action::thrust_left), axis(Action::thrust_up, Action::thrust_down),
                      axis(Action::thrust_back, Action::thrust_ahead)};
    turn_target_ = {axis(Action::pitch_up, Action::pitch_down) + devices.mouse.steer_y,
                    axis(Action::yaw_left, Action::yaw_right) - devices.mouse.steer_x,
                    axis(Action::roll_left, Action::roll_right)};
    turn_target_ = glm::clamp(turn_target_, -1.0, 1.0);

    buttons_ = (strength(devices, Action::boost) > 0.5 ? sim::ControlFrame::boost : 0u) |
               (strength(devices, Action::brake) > 0.5 ? sim::ControlFrame::brake : 0u);
    step_target_ = feel_.step_metres * axis(Action::head_right, Action::head_left);
    press_switches(presses);
    snap(devices, presses);
    turn_head(devices, presses, elapsed_seconds);
}

void DevicePilot::press_switches(const std::vector<Action>& presses) {
    using sim::ControlFrame;
    using sim::Pointing;
    const auto point = [this](Pointing pointing) {
        const std::uint32_t bits = static_cast<std::uint32_t>(pointing) * ControlFrame::first_pointing;
        const bool off = (switches_ & ControlFrame::pointing_mask) == bits;
        switches_ = (switches_ & ~ControlFrame::pointing_mask) | (off ? 0u : bits);
    };
    for (const Action action : presses) {
        switch (action) {
        case Action::autopilot:
            switches_ ^= ControlFrame::autopilot;
            break;
        case Action::brake_switch:
            switches_ ^= ControlFrame::brake;
            break;
        case Action::cruise:
            switches_ ^= ControlFrame::cruise;
            break;
        case Action::dampers:
            switches_ ^= ControlFrame::undamped;
            break;
        case Action::about_target:
            switches_ ^= ControlFrame::about_target;
            break;
        case Action::hold_heading:
            point(Pointing::hold_heading);
            break;
        case Action::point_prograde:
            point(Pointing::prograde);
            break;
        case Action::point_retrograde:
            point(Pointing::retrograde);
            break;
        case Action::point_seen:
            point(Pointing::target_seen);
            break;
        case Action::point_now:
            point(Pointing::target_now);
            break;
        default:
            break;
        }
    }
}

void DevicePilot::snap(const DeviceState& devices, const std::vector<Action>& presses) {
    snaps_to_the_left_ += static_cast<int>(std::ranges::count(presses, Action::snap_left)) -
                          static_cast<int>(std::ranges::count(presses, Action::snap_right));
    if (!snaps_always_) {
        return;
    }
    turn_target_.y = 0.0;
    const double left = strength(devices, Action::yaw_left, feel_.stick);
    const double right = strength(devices, Action::yaw_right, feel_.stick);
    if (ready_to_snap_ && std::max(left, right) >= feel_.snap_at) {
        snaps_to_the_left_ += left > right ? 1 : -1;
        ready_to_snap_ = false;
    }
    ready_to_snap_ = ready_to_snap_ || std::max(left, right) < feel_.snap_again_below;
}

void DevicePilot::recentre() {
    head_ = head_target_ = {0.0, 0.0};
    step_target_ = 0.0;
}

void DevicePilot::move_head(sim::ControlFrame& frame) {
    constexpr double fastest = 0.9; // c: nobody steps as fast as light, however slow that is
    const double tick = 1.0 / vehicle_.tick_rate;
    const double wanted =
        ramped(glm::dvec2(step_, 0.0), glm::dvec2(step_target_, 0.0), approach(seconds_per_tick_, feel_.step_seconds))
            .x;
    const double most = fastest * tick * metres_per_light_unit_;
    const double step = std::clamp(wanted - step_, -most, most);
    step_ += step;
    const glm::dvec3 aside = vehicle_from_seat_ * glm::dvec3(1.0, 0.0, 0.0);
    frame.head_position = step_ / metres_per_light_unit_ * aside;
    frame.head_velocity = step / metres_per_light_unit_ / tick * aside;
}

void DevicePilot::turn_head(const DeviceState& devices, const std::vector<Action>& presses, double elapsed_seconds) {
    for (const Action action : presses) {
        switch (action) {
        case Action::look_ahead:
            head_target_ = {0.0, 0.0};
            break;
        case Action::look_behind:
            head_target_ = {half_turn, 0.0};
            break;
        case Action::look_left:
            head_target_ = {quarter_turn, 0.0};
            break;
        case Action::look_right:
            head_target_ = {-quarter_turn, 0.0};
            break;
        case Action::look_up:
            head_target_ = {0.0, quarter_turn};
            break;
        default:
            break;
        }
    }
    const glm::dvec2 drag = feel_.look_per_height * glm::dvec2(-devices.mouse.look_x, devices.mouse.look_y);
    head_target_ += drag;
    head_ += drag; // the hand is smooth enough: a drag is followed at once
    head_target_.y = std::clamp(head_target_.y, -quarter_turn, quarter_turn);
    head_.y = std::clamp(head_.y, -quarter_turn, quarter_turn);
    head_ = ramped(head_, head_target_, approach(elapsed_seconds, feel_.head_turn_seconds));
}

glm::dquat DevicePilot::vehicle_from_head() const {
    return vehicle_from_seat_ * glm::angleAxis(head_.x, glm::dvec3(0.0, 1.0, 0.0)) *
           glm::angleAxis(head_.y, glm::dvec3(1.0, 0.0, 0.0));
}

std::optional<sim::ControlFrame> DevicePilot::control(sim::Tick /*tick*/) {
    thrust_ = ramped(thrust_, thrust_target_, approach(seconds_per_tick_, feel_.thrust_ramp_seconds));
    turn_ = ramped(turn_, turn_target_, approach(seconds_per_tick_, feel_.turn_ramp_seconds));

    const double boost = (buttons_ & sim::ControlFrame::boost) != 0 ? vehicle_.boost_factor : 1.0;
    sim::ControlFrame frame;
    const glm::dvec3 most_thrust = boost * finite_limit(vehicle_.maximum_acceleration);
    const glm::dvec3 most_turn = finite_limit(vehicle_.maximum_turn_rate);
    frame.proper_acceleration = on_grid(vehicle_from_seat_ * (most_thrust * thrust_), most_thrust);
    frame.angular_velocity = on_grid(vehicle_from_seat_ * (most_turn * turn_), most_turn);
    frame.vehicle_from_head = vehicle_from_head();
    move_head(frame);
    frame.buttons = buttons_ | switches_;
    if (snaps_to_the_left_ != 0) {
        const int way = snaps_to_the_left_ > 0 ? 1 : -1;
        snaps_to_the_left_ -= way;
        frame.angular_velocity = vehicle_from_seat_ * glm::dvec3(0.0, way * snap_angle_ * vehicle_.tick_rate, 0.0);
        frame.buttons |= sim::ControlFrame::snap_turn;
    }
    return frame;
}

} // namespace input

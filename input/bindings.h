#pragma once

#include "input/gamepad.h"
#include "input/keys.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace input {

/// Everything a pilot can do.
enum class Action : std::uint8_t {
    // held: how far, in [0, 1]
    thrust_ahead,
    thrust_back,
    thrust_right,
    thrust_left,
    thrust_up,
    thrust_down,
    pitch_up,
    pitch_down,
    yaw_right,
    yaw_left,
    roll_right,
    roll_left,
    boost,
    brake,
    head_left,
    head_right,
    steer_by_mouse,
    look_by_mouse,
    // pressed once
    look_ahead,
    look_behind,
    look_left,
    look_right,
    look_up,
    snap_left,
    snap_right,
    recentre,
    target_next,
    target_in_view,
    autopilot,
    brake_switch,
    cruise,
    dampers,
    about_target,
    hold_heading,
    point_prograde,
    point_retrograde,
    point_seen,
    point_now,
    mode_next,
    mode_geometry,
    mode_doppler,
    mode_searchlight,
    mode_full,
    exposure_down,
    exposure_up,
    exposure_automatic,
    curve,
    view_next,
    iso_lines,
    split,
    bloom,
    probe,
    zoom,
    pause,
    single_tick,
    slower,
    faster,
    reset,
    bookmark,
    play_backwards,
    single_tick_back,
    ten_seconds_back,
    ten_seconds_ahead,
    previous_mark,
    next_mark,
    take_over,
    camera_next,
    camera_pilot,
    cockpit,
    steady_horizon,
    panel,
    hud,
    screenshot,
    full_screen,
    help,
    quit,
    count,
};

enum class Mouse : std::uint8_t { none, left_drag, right_drag, wheel };

/// One line of the table of controls.
struct Binding {
    Action action;
    std::string_view group; ///< heading it stands under
    std::string_view what;  ///< what it does, for people
    Key key = Key::none;
    Key second_key = Key::none;
    GamepadControl gamepad{};
    Mouse mouse = Mouse::none;
};

/// The one table of controls: it drives the handling, the help overlay and `rapidity fly --controls`.
std::span<const Binding> bindings();

/// Keys and mouse of a binding for people: "W", "Shift or Right Shift", "right mouse drag".
std::string desk_controls(const Binding& binding);

/// Mouse movements since the last sample.
struct MouseState {
    double steer_x = 0.0; ///< left drag: displacement from where it began, in half window heights; +: right
    double steer_y = 0.0; ///< +: up
    double look_x = 0.0;  ///< right drag: movement since the last sample, in window heights; +: right
    double look_y = 0.0;  ///< +: up
    double wheel = 0.0;   ///< notches since the last sample; +: away from the hand
};

/// All devices at one moment, as plain data: whoever has the window fills it.
struct DeviceState {
    KeyState keys;
    MouseState mouse;
    std::optional<GamepadState> gamepad;
};

/// How far an action is pressed on any device, in [0, 1].
double strength(const DeviceState& devices, Action action, const StickResponse& response = {});

} // namespace input

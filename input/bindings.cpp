#include "input/bindings.h"

#include <algorithm>
#include <array>

namespace input {
namespace {

constexpr std::string_view thrust = "Thrust";
constexpr std::string_view turn = "Turn";
constexpr std::string_view look = "Look";
constexpr std::string_view assist = "Assists";
constexpr std::string_view picture = "Picture";
constexpr std::string_view time = "Time";
constexpr std::string_view replay = "Replay";
constexpr std::string_view program = "Program";

using enum Action;
using Pad = GamepadButton;
using Axis = GamepadAxis;

constexpr std::array table{
    Binding{thrust_ahead, thrust, "ahead", Key::w, Key::none, pad_positive(Axis::right_trigger)},
    Binding{thrust_back, thrust, "back", Key::s, Key::none, pad_positive(Axis::left_trigger)},
    Binding{thrust_left, thrust, "left", Key::a, Key::none, pad_negative(Axis::right_x)},
    Binding{thrust_right, thrust, "right", Key::d, Key::none, pad_positive(Axis::right_x)},
    Binding{thrust_up, thrust, "up", Key::r, Key::none, pad_negative(Axis::right_y)},
    Binding{thrust_down, thrust, "down", Key::f, Key::none, pad_positive(Axis::right_y)},
    Binding{boost, thrust, "boost while held", Key::left_shift, Key::right_shift, pad(Pad::a)},
    Binding{brake, thrust, "brake to rest while held", Key::space, Key::none, pad(Pad::b)},

    Binding{pitch_up, turn, "nose up", Key::up, Key::none, pad_positive(Axis::left_y)},
    Binding{pitch_down, turn, "nose down", Key::down, Key::none, pad_negative(Axis::left_y)},
    Binding{yaw_left, turn, "nose left", Key::left, Key::none, pad_negative(Axis::left_x)},
    Binding{yaw_right, turn, "nose right", Key::right, Key::none, pad_positive(Axis::left_x)},
    Binding{roll_left, turn, "roll left", Key::q, Key::none, pad(Pad::left_bumper)},
    Binding{roll_right, turn, "roll right", Key::e, Key::none, pad(Pad::right_bumper)},
    Binding{steer_by_mouse, turn, "steer", Key::none, Key::none, {}, Mouse::left_drag},

    Binding{snap_left, turn, "left by a step", Key::left_control},
    Binding{snap_right, turn, "right by a step", Key::right_control},

    Binding{look_ahead, look, "ahead", Key::digit_1, Key::v, pad(Pad::left_thumb)},
    Binding{look_behind, look, "behind", Key::digit_2, Key::none, pad(Pad::y)},
    Binding{look_left, look, "left", Key::digit_3},
    Binding{look_right, look, "right", Key::digit_4},
    Binding{look_up, look, "up", Key::digit_5},
    Binding{look_by_mouse, look, "around", Key::none, Key::none, {}, Mouse::right_drag},
    Binding{zoom, look, "narrower or wider view", Key::none, Key::none, {}, Mouse::wheel},
    Binding{head_left, look, "step left while held", Key::semicolon},
    Binding{head_right, look, "step right while held", Key::apostrophe},
    Binding{recentre, look, "recentre the seat", Key::del},

    Binding{target_next, assist, "next target", Key::t},
    Binding{target_in_view, assist, "target in view", Key::y},
    Binding{autopilot, assist, "autopilot to the target", Key::g},
    Binding{brake_switch, assist, "brake to rest", Key::b},
    Binding{cruise, assist, "hold this rapidity", Key::k},
    Binding{dampers, assist, "dampers of the turn on, off", Key::j},
    Binding{about_target, assist, "motion: of world or target", Key::z},
    Binding{hold_heading, assist, "hold the heading", Key::digit_6},
    Binding{point_prograde, assist, "nose to where you go", Key::digit_7},
    Binding{point_retrograde, assist, "nose to where you come from", Key::digit_8},
    Binding{point_seen, assist, "nose to target as seen", Key::digit_9},
    Binding{point_now, assist, "nose to target as it is now", Key::digit_0},

    Binding{camera_next, picture, "next camera: free, world, chase, twin", Key::backslash},
    Binding{camera_pilot, picture, "the pilot's own camera", Key::slash},
    Binding{mode_next, picture, "next mode", Key::m, Key::none, pad(Pad::x)},
    Binding{mode_geometry, picture, "geometry only", Key::f5},
    Binding{mode_doppler, picture, "geometry and Doppler", Key::f6},
    Binding{mode_searchlight, picture, "geometry and searchlight", Key::f7},
    Binding{mode_full, picture, "everything", Key::f8},
    Binding{exposure_down, picture, "darker", Key::left_bracket, Key::none, pad(Pad::pad_down)},
    Binding{exposure_up, picture, "brighter", Key::right_bracket, Key::none, pad(Pad::pad_up)},
    Binding{exposure_automatic, picture, "automatic exposure on, off", Key::x},
    Binding{curve, picture, "filmic or linear curve", Key::c},
    Binding{view_next, picture, "light, D, rings or luminance", Key::f2},
    Binding{iso_lines, picture, "lines of equal D on, off", Key::f3},
    Binding{split, picture, "one, two or four panes", Key::f4},
    Binding{bloom, picture, "glare on, off", Key::f9},
    Binding{probe, picture, "spectrum under the mouse", Key::f10},

    Binding{pause, time, "pause", Key::p, Key::none, pad(Pad::start)},
    Binding{single_tick, time, "single tick while paused", Key::n},
    Binding{slower, time, "slower motion", Key::comma, Key::minus, pad(Pad::pad_left)},
    Binding{faster, time, "faster motion", Key::period, Key::equal, pad(Pad::pad_right)},
    Binding{reset, time, "new flight from the start", Key::backspace, Key::none, pad(Pad::back)},

    Binding{bookmark, time, "bookmark in the recording", Key::insert},

    Binding{play_backwards, replay, "backwards, forwards", Key::l},
    Binding{single_tick_back, replay, "single tick back while paused", Key::i},
    Binding{ten_seconds_back, replay, "ten seconds back", Key::page_up},
    Binding{ten_seconds_ahead, replay, "ten seconds ahead", Key::page_down},
    Binding{previous_mark, replay, "to the mark before", Key::home},
    Binding{next_mark, replay, "to the next mark", Key::end},
    Binding{take_over, replay, "take over the controls", Key::o},

    Binding{cockpit, program, "cockpit on, off", Key::enter},
    Binding{steady_horizon, program, "steady horizon on, off", Key::grave_accent},
    Binding{help, program, "help", Key::f1, Key::h, pad(Pad::right_thumb)},
    Binding{panel, program, "settings panel", Key::tab},
    Binding{hud, program, "instruments on, off", Key::u},
    Binding{screenshot, program, "screenshot", Key::f12},
    Binding{full_screen, program, "full screen", Key::f11},
    Binding{quit, program, "quit", Key::escape},
};

std::string_view mouse_name(Mouse mouse) {
    switch (mouse) {
    case Mouse::none:
        return "";
    case Mouse::left_drag:
        return "left mouse drag";
    case Mouse::right_drag:
        return "right mouse drag";
    case Mouse::wheel:
        return "mouse wheel";
    }
    return "";
}

} // namespace

std::span<const Binding> bindings() {
    return table;
}

std::string desk_controls(const Binding& binding) {
    std::string text;
    for (const std::string_view part :
         {key_name(binding.key), key_name(binding.second_key), mouse_name(binding.mouse)}) {
        if (!part.empty()) {
            text += text.empty() ? "" : " or ";
            text += part;
        }
    }
    return text;
}

double strength(const DeviceState& devices, Action action, const StickResponse& response) {
    double strongest = 0.0;
    for (const Binding& binding : table) {
        if (binding.action != action) {
            continue;
        }
        if (devices.keys.down(binding.key) || devices.keys.down(binding.second_key)) {
            return 1.0;
        }
        if (devices.gamepad) {
            strongest = std::max(strongest, pressed(*devices.gamepad, binding.gamepad, response));
        }
    }
    return strongest;
}

} // namespace input

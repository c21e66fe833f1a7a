#include "engine/fly/idle_watch.h"

#include <algorithm>
#include <cmath>

namespace engine {

bool is_touched(const input::DeviceState& devices, bool cursor_moved) {
    const input::MouseState& mouse = devices.mouse;
    const bool dragged = mouse.steer_x != 0.0 || mouse.steer_y != 0.0 || mouse.look_x != 0.0 || mouse.look_y != 0.0;
    if (cursor_moved || dragged || mouse.wheel != 0.0 || devices.keys.any_down()) {
        return true;
    }
    if (!devices.gamepad) {
        return false;
    }
    // A trigger rests at -1; sticks that nobody touches rest within a fifth of the middle.
    const input::GamepadState& pad = *devices.gamepad;
    constexpr float rest = 0.2F;
    for (std::size_t i = 0; i < pad.axes.size(); ++i) {
        const bool trigger = i == static_cast<std::size_t>(input::GamepadAxis::left_trigger) ||
                             i == static_cast<std::size_t>(input::GamepadAxis::right_trigger);
        if (trigger ? pad.axes.at(i) > rest - 1.0F : std::abs(pad.axes.at(i)) > rest) {
            return true;
        }
    }
    return std::ranges::any_of(pad.buttons, [](bool down) { return down; });
}

} // namespace engine

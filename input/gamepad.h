#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace input {

/// Axes and buttons as GLFW's mapping database names them (the engine checks the values against GLFW).
enum class GamepadAxis : std::uint8_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger };
enum class GamepadButton : std::uint8_t {
    a,
    b,
    x,
    y,
    left_bumper,
    right_bumper,
    back,
    start,
    guide,
    left_thumb,
    right_thumb,
    pad_up,
    pad_right,
    pad_down,
    pad_left,
};

/// A gamepad as sampled: sticks in [-1, 1] (y grows downwards), triggers in [-1, 1] from released to pressed.
struct GamepadState {
    std::string name;
    std::array<float, 6> axes{0.0F, 0.0F, 0.0F, 0.0F, -1.0F, -1.0F};
    std::array<bool, 15> buttons{};
};

/// How a stick answers: nothing inside the dead zone, then from 0 to 1 along x^exponent, so that small movements are
/// fine and full deflection is full demand.
struct StickResponse {
    double dead_zone = 0.12; ///< of the deflection, in [0, 1)
    double exponent = 1.8;   ///< >= 1
};

/// Answer in [0, 1] to a deflection in [0, 1].
double respond(double deflection, const StickResponse& response);

/// One binding on a gamepad: a button, or one half of an axis.
struct GamepadControl {
    enum class Kind : std::uint8_t { none, button, positive_half, negative_half };
    Kind kind = Kind::none;
    std::uint8_t index = 0;
};

constexpr GamepadControl pad(GamepadButton button) {
    return {GamepadControl::Kind::button, static_cast<std::uint8_t>(button)};
}
constexpr GamepadControl pad_positive(GamepadAxis axis) {
    return {GamepadControl::Kind::positive_half, static_cast<std::uint8_t>(axis)};
}
constexpr GamepadControl pad_negative(GamepadAxis axis) {
    return {GamepadControl::Kind::negative_half, static_cast<std::uint8_t>(axis)};
}

/// How far a control is pressed, in [0, 1], after dead zone and curve. Sticks answer by their deflection from the
/// centre in any direction, so that a diagonal is neither dead nor too strong.
double pressed(const GamepadState& gamepad, GamepadControl control, const StickResponse& response);

/// For people: "left stick up", "A"; "" for none.
std::string_view control_name(GamepadControl control);

} // namespace input

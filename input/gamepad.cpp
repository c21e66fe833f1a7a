#include "input/gamepad.h"

#include <algorithm>
#include <cmath>

namespace input {
namespace {

constexpr std::size_t first_trigger = static_cast<std::size_t>(GamepadAxis::left_trigger);

/// An axis in [-1, 1] after dead zone and curve; triggers in [0, 1].
double conditioned_axis(const GamepadState& gamepad, std::size_t axis, const StickResponse& response) {
    const auto raw = static_cast<double>(gamepad.axes.at(axis));
    if (axis >= first_trigger) {
        return respond(0.5 * (raw + 1.0), response);
    }
    const std::size_t partner = axis ^ std::size_t{1}; // x and y of one stick are neighbours
    const double deflection = std::hypot(raw, static_cast<double>(gamepad.axes.at(partner)));
    return deflection > 0.0 ? respond(deflection, response) * raw / deflection : 0.0;
}

} // namespace

double respond(double deflection, const StickResponse& response) {
    if (!(deflection > response.dead_zone)) {
        return 0.0;
    }
    const double live = (deflection - response.dead_zone) / (1.0 - response.dead_zone);
    return std::pow(std::min(live, 1.0), response.exponent);
}

double pressed(const GamepadState& gamepad, GamepadControl control, const StickResponse& response) {
    switch (control.kind) {
    case GamepadControl::Kind::none:
        return 0.0;
    case GamepadControl::Kind::button:
        return gamepad.buttons.at(control.index) ? 1.0 : 0.0;
    case GamepadControl::Kind::positive_half:
        return std::max(conditioned_axis(gamepad, control.index, response), 0.0);
    case GamepadControl::Kind::negative_half:
        return std::max(-conditioned_axis(gamepad, control.index, response), 0.0);
    }
    return 0.0;
}

std::string_view control_name(GamepadControl control) {
    static constexpr std::array<std::string_view, 15> buttons{
        "A",     "B",          "X",           "Y",      "left bumper", "right bumper", "Back",    "Start",
        "Guide", "left thumb", "right thumb", "pad up", "pad right",   "pad down",     "pad left"};
    static constexpr std::array<std::string_view, 6> positive{"left stick right",  "left stick down",
                                                              "right stick right", "right stick down",
                                                              "left trigger",      "right trigger"};
    static constexpr std::array<std::string_view, 6> negative{
        "left stick left", "left stick up", "right stick left", "right stick up", "", ""};
    switch (control.kind) {
    case GamepadControl::Kind::none:
        return "";
    case GamepadControl::Kind::button:
        return buttons.at(control.index);
    case GamepadControl::Kind::positive_half:
        return positive.at(control.index);
    case GamepadControl::Kind::negative_half:
        return negative.at(control.index);
    }
    return "";
}

} // namespace input

#include "input/press_detector.h"

namespace input {

std::vector<Action> PressDetector::presses(const DeviceState& devices) {
    std::vector<Action> pressed_now;
    for (const Binding& binding : bindings()) {
        const auto index = static_cast<std::size_t>(binding.action);
        const bool down = strength(devices, binding.action) > 0.5;
        if (down && !down_.test(index)) {
            pressed_now.push_back(binding.action);
        }
        down_.set(index, down);
    }
    return pressed_now;
}

} // namespace input

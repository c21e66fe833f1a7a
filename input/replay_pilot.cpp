#include "input/replay_pilot.h"

#include <utility>

namespace input {

ReplayPilot::ReplayPilot(std::vector<TimedControl> controls, sim::Tick end)
    : controls_(std::move(controls)), end_(end) {}

std::optional<sim::ControlFrame> ReplayPilot::control(sim::Tick tick) {
    if (tick >= end_) {
        return std::nullopt;
    }
    while (next_ < controls_.size() && controls_[next_].tick <= tick) {
        present_ = controls_[next_].control;
        ++next_;
    }
    return present_;
}

} // namespace input

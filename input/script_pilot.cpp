#include "input/script_pilot.h"

#include <cmath>
#include <utility>

namespace input {

ScriptPilot::ScriptPilot(sim::FlightScript script, double tick_rate)
    : script_(std::move(script)), tick_rate_(tick_rate),
      segment_end_(script_.empty() ? 0.0 : script_.front().duration.value) {}

std::optional<sim::ControlFrame> ScriptPilot::control(sim::Tick tick) {
    while (segment_ < script_.size() && static_cast<double>(tick) >= std::round(segment_end_ * tick_rate_)) {
        ++segment_;
        if (segment_ < script_.size()) {
            segment_end_ += script_[segment_].duration.value;
        }
    }
    if (segment_ >= script_.size()) {
        return std::nullopt;
    }
    sim::ControlFrame frame;
    frame.proper_acceleration = script_[segment_].proper_acceleration;
    frame.angular_velocity = script_[segment_].angular_velocity;
    return frame;
}

} // namespace input

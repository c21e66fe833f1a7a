#include "engine/fixed_step.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace engine {

FixedStep::FixedStep(double tick_rate, double longest_frame_seconds)
    : tick_rate_(tick_rate), longest_frame_seconds_(longest_frame_seconds) {
    assert(tick_rate > 0.0 && longest_frame_seconds > 0.0);
}

void FixedStep::set_pace(double clock_units_per_second) {
    assert(clock_units_per_second > 0.0);
    pace_ = clock_units_per_second;
}

FixedStep::Steps FixedStep::advance(double elapsed_seconds) {
    Steps steps;
    if (paused_) {
        steps.ticks = std::exchange(single_ticks_, 0);
    } else {
        single_ticks_ = 0;
        const double counted = std::clamp(elapsed_seconds, 0.0, longest_frame_seconds_);
        steps.dropped_seconds = std::max(elapsed_seconds, 0.0) - counted;
        const double due = fraction_ + counted * pace_ * tick_rate_;
        const double whole = std::floor(due);
        steps.ticks = static_cast<sim::Tick>(whole);
        fraction_ = due - whole;
    }
    steps.fraction = fraction_;
    return steps;
}

} // namespace engine

#include "engine/dynamic_resolution.h"

#include <algorithm>
#include <cmath>

namespace engine {
namespace {

/// Frames to watch before a change: down soon, up only when sure, so that one slow frame changes nothing.
constexpr int frames_before_down = 3;
constexpr int frames_before_up = 20;

/// Weight of the newest frame in the running mean.
constexpr double newest_weight = 0.3;

} // namespace

DynamicResolution::DynamicResolution(double budget_seconds) : budget_seconds_(budget_seconds) {}

double DynamicResolution::update(double frame_seconds) {
    smoothed_seconds_ = frames_at_scale_ == 0
                            ? frame_seconds
                            : (1.0 - newest_weight) * smoothed_seconds_ + newest_weight * frame_seconds;
    ++frames_at_scale_;

    // Cost goes at most with the number of pixels, so this never asks for a larger step down than is needed.
    const double wanted = scale_ * std::sqrt(budget_seconds_ / std::max(smoothed_seconds_, 1e-6));
    double next = scale_;
    if (smoothed_seconds_ > budget_seconds_ && frames_at_scale_ >= frames_before_down) {
        next = std::min(std::floor(wanted / step) * step, scale_ - step);
    } else if (wanted >= scale_ + 1.5 * step && frames_at_scale_ >= frames_before_up) {
        next = scale_ + step; // half a step in reserve, or it would swing back
    }
    next = std::clamp(next, smallest, 1.0);
    if (next != scale_) {
        scale_ = next;
        frames_at_scale_ = 0;
    }
    return scale_;
}

} // namespace engine

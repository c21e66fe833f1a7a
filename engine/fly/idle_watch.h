#pragma once

#include "input/bindings.h"

namespace engine {

/// Waits until nobody has touched anything for a while: a demonstration then returns to its start.
class IdleWatch {
  public:
    /// `limit_seconds` > 0.
    explicit IdleWatch(double limit_seconds) : limit_(limit_seconds) {}

    /// Time passes; somebody touched something in it or not.
    void advance(double elapsed_seconds, bool touched) { idle_ = touched ? 0.0 : idle_ + elapsed_seconds; }
    double limit() const { return limit_; }
    double seconds_left() const { return idle_ < limit_ ? limit_ - idle_ : 0.0; }
    bool over() const { return idle_ >= limit_; }
    /// From the start again.
    void begin() { idle_ = 0.0; }

  private:
    double limit_;
    double idle_ = 0.0;
};

/// Whether a hand is on the keys, the mouse or the gamepad. `cursor_moved`: DeviceState does not tell.
bool is_touched(const input::DeviceState& devices, bool cursor_moved);

} // namespace engine

#pragma once

#include "sim/control_frame.h"
#include "sim/quantities.h"

#include <optional>

namespace input {

/// Whoever makes the ControlFrames: devices, a script, a recording. Asked exactly once per tick, in order.
class Pilot {
  public:
    virtual ~Pilot() = default;
    /// The demand for this tick; empty when this pilot has come to its end.
    virtual std::optional<sim::ControlFrame> control(sim::Tick tick) = 0;
};

} // namespace input

#pragma once

#include "input/pilot.h"

namespace input {

/// Looks ahead and leaves everything to the autopilot.
class AutopilotPilot final : public Pilot {
  public:
    /// Never ends.
    std::optional<sim::ControlFrame> control(sim::Tick /*tick*/) override {
        sim::ControlFrame frame;
        frame.buttons = sim::ControlFrame::autopilot;
        return frame;
    }
};

} // namespace input

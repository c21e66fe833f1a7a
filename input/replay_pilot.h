#pragma once

#include "input/pilot.h"

#include <vector>

namespace input {

/// A demand and the first tick it holds for; it holds until the next one's tick.
struct TimedControl {
    sim::Tick tick = 0;
    sim::ControlFrame control;
};

/// Flies a flight again from the demands that were recorded.
class ReplayPilot final : public Pilot {
  public:
    /// `controls` by rising tick; nothing is demanded before the first. `end`: the first tick that was not flown.
    ReplayPilot(std::vector<TimedControl> controls, sim::Tick end);

    std::optional<sim::ControlFrame> control(sim::Tick tick) override;

  private:
    std::vector<TimedControl> controls_;
    sim::Tick end_;
    std::size_t next_ = 0;
    sim::ControlFrame present_;
};

} // namespace input

#pragma once

#include "input/pilot.h"
#include "sim/flight_script.h"

namespace input {

/// Flies a script. Each segment lasts the whole number of ticks nearest to its duration, counted from the flight's
/// start so that roundings do not add up.
class ScriptPilot final : public Pilot {
  public:
    /// `tick_rate`: ticks per clock unit of ship time.
    ScriptPilot(sim::FlightScript script, double tick_rate);

    std::optional<sim::ControlFrame> control(sim::Tick tick) override;

  private:
    sim::FlightScript script_;
    double tick_rate_;
    std::size_t segment_ = 0;
    double segment_end_;
};

} // namespace input

#pragma once

#include "sim/vehicle.h"

#include <optional>
#include <string_view>

/// What is worth noting of a flight: read off its states, never part of them.
namespace sim {

enum class FlightEventKind : std::uint8_t {
    departure, ///< from rest in the world
    flip,      ///< turnover of the autopilot's trip; by hand: the nose turns from ahead to behind, or back
    arrival,   ///< at the autopilot's target; by hand: at rest in the world
    propellant_spent,
    handed_back, ///< the autopilot has given up: no target or too little propellant
};

struct FlightEvent {
    FlightEventKind kind = FlightEventKind::departure;
    Tick tick = 0; ///< after which it had happened
    ProperTime ship_clock;
    CoordinateTime world_clock;

    friend bool operator==(const FlightEvent&, const FlightEvent&) = default;
};

/// "departure", "flip", ...
std::string_view event_name(FlightEventKind kind);

/// Watches a flight, tick by tick.
class FlightLog {
  public:
    /// What happened during a tick, the most telling if several did.
    std::optional<FlightEvent> watch(const VehicleState& before, const VehicleState& after,
                                     const VehicleSettings& settings);

  private:
    /// 1 or -1: the nose was last clearly along the motion or against it; 0: not yet. Between the two nothing is told,
    /// so that a ship that flies sideways does not flip with every rounding.
    int facing_ = 0;
};

} // namespace sim

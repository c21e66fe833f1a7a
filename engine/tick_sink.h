#pragma once

#include "sim/control_frame.h"
#include "sim/flight_log.h"
#include "sim/vehicle.h"

#include <string>

namespace engine {

/// Something besides the physics that changed a flight between two ticks: the panel's speed of light or vehicle limits.
struct FlightChange {
    std::string what;             ///< one line for people: "speed of light = 30 m/s"
    sim::VehicleState state;      ///< the flight goes on from here; its tick is unchanged
    sim::VehicleSettings vehicle; ///< and with these limits
    double metres_per_light_unit; ///< scene metres in one light clock unit from here on
};

/// A frame that a headset showed: the head that it was drawn for, between the ticks' heads.
struct ShownFrame {
    sim::Tick tick = 0;     ///< the last that was flown
    double fraction = 0.0;  ///< of that tick that had passed, in [0, 1)
    sim::ControlFrame head; ///< only the head's place, orientation and velocity count
};

/// Listens to a flight, tick by tick: the recorder. Must not throw for troubles of its own (a full disk): the flight
/// goes on, and `trouble` says what is wrong. A reset of the flight is a new flight with a new sink.
class TickSink {
  public:
    virtual ~TickSink() = default;
    /// Called once per tick, in order, after the physics: what the pilot demanded and the state it led to.
    virtual void on_tick(const sim::ControlFrame& control, const sim::VehicleState& after) = 0;
    /// Called after the tick that it happened in: a departure, a flip, an arrival.
    virtual void on_event(const sim::FlightEvent& event) = 0;
    /// Called after the frame's ticks, in a headset only. It changes nothing of the flight.
    virtual void on_frame(const ShownFrame& /*frame*/) {}
    /// Called between two ticks.
    virtual void on_change(const FlightChange& change) = 0;
    /// One line on what stopped or hinders this sink; "" while all is well. Shown by the HUD.
    virtual std::string trouble() const = 0;
};

} // namespace engine

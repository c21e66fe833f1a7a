#pragma once

#include "content/scenario.h"
#include "engine/tick_sink.h"
#include "input/pilot.h"
#include "sim/flight_log.h"
#include "sim/vehicle.h"

#include <memory>
#include <string>
#include <vector>

namespace engine {

/// The ship where a scenario starts: nose along start_look with world up as near up as can be, moving by a pure boost
/// along start_heading, all clocks at zero.
sim::VehicleState starting_state(const content::Scenario& scenario);

/// The start as the first entry of a recording.
FlightChange starting_change(const content::Scenario& scenario);

/// One flight: the ship, tick by tick, under a pilot. Knows no clock, window or frame rate.
class Flight {
  public:
    /// Starts at starting_state. `sink` hears every tick; may be null.
    Flight(const content::Scenario& scenario, std::unique_ptr<TickSink> sink);

    /// Flies a recorded flight: goes on from the first of `changes`, and makes each of the others before the tick that
    /// it was made at. At least one, by rising tick.
    void follow(std::vector<FlightChange> changes);

    /// Flies one tick as the pilot demands; false, and nothing done, when the pilot has come to its end or the flight
    /// is stopped.
    bool tick(input::Pilot& pilot);
    /// Why the flight stands still for good, in one line: the next tick would have left what can be computed
    /// (sim::is_in_range). "" while it flies. The state is the last one in range.
    const std::string& stop() const { return stop_; }

    /// After the last tick.
    const sim::VehicleState& state() const { return after_; }
    const sim::VehicleSettings& vehicle() const { return vehicle_; }
    /// The last demand.
    const sim::ControlFrame& control() const { return control_; }

    /// The ship between the last tick but one (0) and the last (1): one step of part of the tick's length under what
    /// was flown, so the picture moves as the physics does, and meets the ticks exactly. `tick` is the last one's.
    sim::VehicleState between(double fraction) const;
    /// The head's orientation between the last two ticks.
    glm::dquat head_between(double fraction) const;

    /// Scene metres in one light clock unit.
    double metres_per_light_unit() const { return metres_per_light_unit_; }
    double speed_of_light() const { return metres_per_light_unit_ / clock_unit_seconds_; }
    /// Another speed of light, metres per second, > 0: the ship stays where it is in the scene and keeps its rapidity,
    /// so the picture stays as it was.
    void set_speed_of_light(double metres_per_second);
    void set_vehicle(const sim::VehicleSettings& vehicle, const std::string& what);
    /// Another target for assists and autopilot, which begins anew; `name`: for the recording.
    void set_target(const sim::InertialObject& target, const std::string& name);
    /// Another rapidity for the cruise assist.
    void set_cruise(sim::Rapidity cruise);

    /// Departures, flips and arrivals so far.
    const std::vector<sim::FlightEvent>& events() const { return events_; }

    /// What hinders the recording; "" while all is well.
    std::string trouble() const { return sink_ ? sink_->trouble() : std::string(); }
    bool has_sink() const { return sink_ != nullptr; }

  private:
    void tell_change(const std::string& what);
    void make_due_changes();
    void stop_for_good();

    sim::VehicleSettings vehicle_;
    double metres_per_light_unit_;
    double clock_unit_seconds_;
    sim::VehicleState before_;
    sim::VehicleState after_;
    sim::ControlFrame control_before_;
    sim::ControlFrame control_;
    std::string stop_;
    std::unique_ptr<TickSink> sink_;
    std::vector<FlightChange> recorded_changes_;
    std::size_t next_recorded_change_ = 0;
    sim::FlightLog log_;
    std::vector<sim::FlightEvent> events_;
};

} // namespace engine

#pragma once

#include "content/scenario.h"
#include "engine/tick_sink.h"
#include "input/pilot.h"
#include "sim/flight_log.h"
#include "sim/ship_world_line.h"
#include "sim/vehicle.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace engine {

/// The ship where a scenario starts: nose along start_look with world up as near up as can be, moving by a pure boost
/// along start_heading, all clocks at zero.
sim::VehicleState starting_state(const content::Scenario& scenario);

/// The start as the first entry of a recording.
FlightChange starting_change(const content::Scenario& scenario);

/// A flight between two ticks, whoever flies it: all that a picture of it needs.
struct FlightMoment {
    sim::VehicleState before; ///< after the last tick but one
    sim::VehicleState after;  ///< after the last
    sim::ControlFrame control_before;
    sim::ControlFrame control;
    sim::VehicleSettings vehicle;
    double metres_per_light_unit = 1.0;
    double fraction = 0.0; ///< of the last tick that has passed, in [0, 1]

    /// The ship just then: one step of part of the tick's length under what was flown, so the picture moves as the
    /// physics does, and meets the ticks exactly. `tick` is the last one's.
    sim::VehicleState between() const;
    /// The head's orientation just then.
    glm::dquat head() const;
};

/// One flight: the ship, tick by tick, under a pilot. Knows no clock, window or frame rate.
class Flight {
  public:
    /// Starts at starting_state. `sink` hears every tick; may be null.
    Flight(const content::Scenario& scenario, std::unique_ptr<TickSink> sink);

    /// Begins where another flight was, at one of its ticks, without telling the sink: a recording begins with it.
    void begin_at(const FlightChange& start);
    /// Shows a moment of a flight that somebody else flies: a replay.
    void show(const FlightMoment& moment);

    /// From here on remembers where the ship has been, for who sees it from elsewhere. Another speed of light begins
    /// that anew.
    void keep_world_line();
    /// The same, with a past.
    void keep_world_line(sim::ShipWorldLine flown);
    /// The world line of a flight that is shown.
    void show_world_line(std::shared_ptr<const sim::ShipWorldLine> line) { shown_world_line_ = std::move(line); }
    /// None while it is not kept.
    std::shared_ptr<const sim::ShipWorldLine> world_line() const {
        return shown_world_line_ ? shown_world_line_ : world_line_;
    }

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

    /// The ship between the last tick but one (0) and the last (1), see FlightMoment.
    FlightMoment moment(double fraction) const;
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
    /// Notes this moment in the recording; changes nothing of the flight.
    void bookmark(const std::string& name) { tell_change("bookmark: " + name); }

    /// Notes in the recording what a headset shows now.
    void note_frame(double fraction, const sim::ControlFrame& head) {
        if (sink_) {
            sink_->on_frame({after_.tick, fraction, head});
        }
    }

    /// What hinders the recording; "" while all is well.
    std::string trouble() const { return sink_ ? sink_->trouble() : std::string(); }
    bool has_sink() const { return sink_ != nullptr; }

  private:
    void tell_change(const std::string& what);
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
    sim::FlightLog log_;
    std::vector<sim::FlightEvent> events_;
    std::shared_ptr<sim::ShipWorldLine> world_line_;
    std::shared_ptr<const sim::ShipWorldLine> shown_world_line_;
};

} // namespace engine

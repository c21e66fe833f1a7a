#pragma once

#include "content/scenario.h"
#include "engine/recorder.h"
#include "engine/temporary_folder.h"

#include <filesystem>
#include <random>
#include <string>

/// Flights to record in tests, and a folder to record them in.
namespace recorded_flight {

using Folder = engine::TemporaryFolder;

content::Scenario scenario();
engine::FlightChange start(const content::Scenario& scenario);

/// A restless hand: new thrust and turn at most ticks, pauses, boost and brake now and then. Repeatable.
class RestlessHand {
  public:
    sim::ControlFrame next();

  private:
    std::mt19937 random_{20010812};
    sim::ControlFrame held_;
};

/// A flight that tells a sink of every tick.
class Flight {
  public:
    Flight(engine::TickSink& sink, const engine::FlightChange& start)
        : sink_(sink), state_(start.state), settings_(start.vehicle),
          metres_per_light_unit_(start.metres_per_light_unit) {}

    void fly(sim::Tick ticks);
    /// The ship is suddenly elsewhere and weaker, as by a panel.
    void change();
    const sim::VehicleState& state() const { return state_; }

  private:
    engine::TickSink& sink_;
    sim::VehicleState state_;
    sim::VehicleSettings settings_;
    double metres_per_light_unit_;
    RestlessHand hand_;
};

/// Records `ticks` ticks with a change in the middle, and closes the file. Returns the last state.
sim::VehicleState record(const std::filesystem::path& file, sim::Tick ticks);

} // namespace recorded_flight

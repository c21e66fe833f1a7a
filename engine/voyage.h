#pragma once

#include "content/destination.h"
#include "content/scenario.h"
#include "sim/flight_log.h"
#include "sim/trip.h"

#include <CLI/App.hpp>

#include <functional>
#include <string>
#include <vector>

namespace engine {

/// A trip as it is asked for on the command line.
struct VoyageOptions {
    std::string to;
    std::string acceleration;  ///< c per clock unit; "": the scenario's
    std::string propellant;    ///< in masses of the ship without it; "": the scenario's
    std::string exhaust_speed; ///< c; "": the scenario's
};
void add_voyage_options(CLI::App& command, VoyageOptions& options);

/// A trip of the autopilot, foretold.
struct Voyage {
    content::Scenario scenario; ///< with the vehicle that the options ask for
    content::Destination destination;
    sim::VehicleState start;
    sim::TripForecast plan;
    double distance = 0.0; ///< light clock units, in the destination's frame
};

/// From where the scenario starts. Throws sim::BadInput for options out of range, an unknown destination, and a trip
/// that cannot be flown.
Voyage plan_voyage(const content::Scenario& scenario, const VoyageOptions& options);

/// A voyage that was flown.
struct FlownVoyage {
    sim::VehicleState end;
    double peak_gamma = 1.0;
    std::vector<sim::FlightEvent> events;
};

/// Flies a voyage by the simulation alone; `visit` hears of every state, the start first. Throws Failure when the ship
/// does not arrive.
FlownVoyage fly_voyage(const Voyage& voyage, const std::function<void(const sim::VehicleState&)>& visit);

/// Prints forecast and flight side by side, and the events. Throws Failure when they differ by more than 0.1 %.
void compare_with_plan(const Voyage& voyage, const FlownVoyage& flown);

} // namespace engine

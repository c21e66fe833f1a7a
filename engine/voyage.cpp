#include "engine/voyage.h"

#include "engine/failure.h"
#include "engine/flight.h"
#include "engine/hud/readouts.h"
#include "engine/navigation.h"
#include "engine/option_values.h"
#include "sim/approach.h"
#include "sim/autopilot.h"
#include "sim/bad_input.h"
#include "sim/propellant.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

/// An option that is there and in range; `value` stays as it is when there is none.
void read_option(const std::string& name, const std::string& text, double lowest, double highest, double& value) {
    if (!text.empty()) {
        value = number_option(name, text, lowest, highest);
    }
}

} // namespace

void add_voyage_options(CLI::App& command, VoyageOptions& options) {
    command.add_option("--to", options.to, "where to: a beacon or a star, by name or as \"HIP 71683\"");
    command.add_option("--acceleration", options.acceleration, "c per clock unit, all axes (default: the scenario's)");
    command.add_option("--propellant", options.propellant,
                       "in masses of the ship without it (default: the scenario's)");
    command.add_option("--exhaust-speed", options.exhaust_speed, "of the propellant, in c (default: the scenario's)");
}

Voyage plan_voyage(const content::Scenario& scenario, const VoyageOptions& options) {
    Voyage voyage;
    voyage.scenario = scenario;
    sim::VehicleSettings& vehicle = voyage.scenario.vehicle;
    double acceleration = 0.0;
    read_option("--acceleration", options.acceleration, 1e-30, 1e30, acceleration);
    if (acceleration > 0.0) {
        vehicle.maximum_acceleration = glm::dvec3(acceleration);
    }
    read_option("--propellant", options.propellant, 0.0, 1e300, vehicle.propellant);
    read_option("--exhaust-speed", options.exhaust_speed, 1e-9, 1.0, vehicle.exhaust_speed);

    voyage.destination = content::find_destination(content::destinations(scenario, scenario.metres_per_light_unit()),
                                                   "--to", options.to);
    voyage.start = starting_state(voyage.scenario);
    voyage.start.guidance.target = voyage.destination.object;
    voyage.start.guidance.has_target = 1;
    voyage.plan = sim::plan_trip(voyage.start, vehicle);
    voyage.distance = glm::length(sim::approach(voyage.start, voyage.destination.object).way);
    const std::string problem = problem_text(voyage.plan, vehicle, scenario.clock_unit_name);
    if (!problem.empty()) {
        throw sim::BadInput("--to", "", options.to, problem);
    }
    return voyage;
}

FlownVoyage fly_voyage(const Voyage& voyage, const std::function<void(const sim::VehicleState&)>& visit) {
    const sim::VehicleSettings& vehicle = voyage.scenario.vehicle;
    sim::ControlFrame control;
    control.buttons = sim::ControlFrame::autopilot;
    sim::FlightLog log;
    FlownVoyage flown;
    flown.end = voyage.start;
    visit(flown.end);
    // Corrections may take some ticks more than foretold; a trip twice as long has gone wrong.
    const auto most = static_cast<sim::Tick>(2.0 * voyage.plan.ship_time.value * vehicle.tick_rate) + 1000;
    do {
        const sim::VehicleState before = flown.end;
        flown.end = sim::advance(before, vehicle, control);
        flown.peak_gamma = std::max(flown.peak_gamma, sim::four_velocity(flown.end.world_from_vehicle).t);
        if (const auto event = log.watch(before, flown.end, vehicle)) {
            flown.events.push_back(*event);
        }
        visit(flown.end);
    } while (sim::is_flying(flown.end.guidance.phase) && flown.end.tick < most);
    if (flown.end.guidance.phase != sim::AutopilotPhase::arrived) {
        throw Failure(fmt::format("{}: the autopilot has not arrived after {} ticks: {}", voyage.destination.name,
                                  flown.end.tick, sim::phase_name(flown.end.guidance.phase)));
    }
    return flown;
}

void compare_with_plan(const Voyage& voyage, const FlownVoyage& flown) {
    constexpr double allowed = 1e-3;
    const std::string& unit = voyage.scenario.clock_unit_name;
    const sim::TripForecast& plan = voyage.plan;
    const sim::Approach end = sim::approach(flown.end, voyage.destination.object);
    double worst = 0.0;
    const auto line = [&](const char* what, double foretold, double flew, const std::string& in) {
        const double difference = flew / foretold - 1.0;
        worst = std::max(worst, std::abs(difference));
        fmt::print("{:<12} {:>14.8g} {:>14.8g} {:<3} {:+.1e}\n", what, foretold, flew, in, difference);
    };
    fmt::print("{} to {}, {}\n{:<12} {:>14} {:>14}     difference\n", voyage.scenario.name, voyage.destination.name,
               distance_text(voyage.distance, unit), "", "foretold", "flown");
    line("ship time", plan.ship_time.value, flown.end.ship_clock.value, unit);
    line("world time", plan.world_time.value, flown.end.event.t - voyage.start.event.t, unit);
    line("peak gamma", plan.peak_gamma, flown.peak_gamma, "");
    line("mass ratio", plan.mass_ratio, sim::mass_ratio(voyage.scenario.vehicle, flown.end.rapidity_spent), "");
    fmt::print("at rest {:.2g} m from the target, at {:.2g} m/s\n",
               glm::length(end.way) * voyage.scenario.metres_per_light_unit(),
               std::tanh(end.motion.xi.value) * voyage.scenario.speed_of_light);
    for (const sim::FlightEvent& event : flown.events) {
        fmt::print("{:<12} ship {:.6g} {}, world {:.6g} {}\n", sim::event_name(event.kind), event.ship_clock.value,
                   unit, event.world_clock.value, unit);
    }
    if (worst > allowed) {
        throw Failure(fmt::format("the flight differs from its forecast by {:.1e}, more than {:g}", worst, allowed));
    }
}

} // namespace engine

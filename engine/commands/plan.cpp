#include "engine/commands/commands.h"

#include "content/destination.h"
#include "engine/flight.h"
#include "engine/hud/readouts.h"
#include "engine/navigation.h"
#include "engine/option_values.h"
#include "engine/voyage.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fmt/core.h>
#include <memory>

namespace engine {
namespace {

struct PlanOptions {
    std::string scenario = "stars";
    VoyageOptions voyage;
    bool list = false;
    bool json = false;
};

void list_destinations(const content::Scenario& scenario) {
    for (const content::Destination& destination : content::destinations(scenario, scenario.metres_per_light_unit())) {
        const sim::Event start = starting_state(scenario).event;
        fmt::print(
            "{:<18} {:<12} {}\n", destination.name,
            destination.hip != 0 ? fmt::format("HIP {}", destination.hip) : "clock",
            distance_text(glm::distance(destination.object.position_at_zero, start.space), scenario.clock_unit_name));
    }
}

void print_json(const Voyage& voyage) {
    const sim::TripForecast& plan = voyage.plan;
    const double tick = 1.0 / voyage.scenario.vehicle.tick_rate;
    const auto text = nlohmann::json{
        {"scenario", voyage.scenario.name},
        {"to", voyage.destination.name},
        {"hip", voyage.destination.hip},
        {"clock_unit", voyage.scenario.clock_unit_name},
        {"clock_unit_seconds", voyage.scenario.clock_unit_seconds},
        {"distance", voyage.distance},
        {"ship_time", plan.ship_time.value},
        {"world_time", plan.world_time.value},
        {"peak_gamma", plan.peak_gamma},
        {"rapidity_spent", plan.rapidity_spent.value},
        {"mass_ratio", plan.mass_ratio},
        {"propellant_per_mass_arriving", plan.mass_ratio - 1.0},
        {"exhaust_speed", voyage.scenario.vehicle.exhaust_speed},
        {"stopping_time", plan.stopping_ticks * tick},
        {"turning_time", plan.trip.schedule.wait * tick},
        {"accelerating_time", plan.trip.schedule.first * tick},
        {"coasting_time", plan.trip.schedule.coast * tick},
        {"braking_time", plan.trip.schedule.second * tick},
    };
    fmt::print("{}\n", text.dump(2));
}

void print_text(const Voyage& voyage) {
    const sim::TripForecast& plan = voyage.plan;
    const std::string& unit = voyage.scenario.clock_unit_name;
    const double tick = 1.0 / voyage.scenario.vehicle.tick_rate;
    fmt::print("{} to {}{}: {}\n", voyage.scenario.name, voyage.destination.name,
               voyage.destination.hip != 0 ? fmt::format(" (HIP {})", voyage.destination.hip) : "",
               distance_text(voyage.distance, unit));
    fmt::print("ship time   {:.6g} {}\n", plan.ship_time.value, unit);
    fmt::print("world time  {:.6g} {}\n", plan.world_time.value, unit);
    fmt::print("peak gamma  {:.6g} (rapidity {:.5g})\n", plan.peak_gamma, std::acosh(plan.peak_gamma));
    fmt::print("propellant  {:.4g} times the mass that arrives, with an exhaust at {:g} c\n", plan.mass_ratio - 1.0,
               voyage.scenario.vehicle.exhaust_speed);
    fmt::print("burns       ");
    const auto part = [&](const char* what, double ticks, bool always) {
        if (ticks > 0.0 || always) {
            fmt::print("{} {:.5g} {}", what, ticks * tick, unit);
        }
    };
    part("to rest first", plan.stopping_ticks, false);
    part(plan.stopping_ticks > 0.0 ? ", turn" : "turn", plan.trip.schedule.wait, false);
    part(plan.stopping_ticks + plan.trip.schedule.wait > 0.0 ? ", accelerate" : "accelerate", plan.trip.schedule.first,
         true);
    part(", coast", plan.trip.schedule.coast, false);
    part(", brake", plan.trip.schedule.second, true);
    fmt::print("\n");
}

void plan(const PlanOptions& options) {
    const content::Scenario scenario = content::load_scenario(options.scenario);
    if (options.list) {
        list_destinations(scenario);
        return;
    }
    if (options.voyage.to.empty()) {
        throw sim::BadInput("--to", "", "", "is missing: where to? --list shows what there is");
    }
    const Voyage voyage = plan_voyage(scenario, options.voyage);
    options.json ? print_json(voyage) : print_text(voyage);
}

} // namespace

void add_plan_command(CLI::App& application) {
    const auto options = std::make_shared<PlanOptions>();
    CLI::App* command = application.add_subcommand(
        "plan", "foretell a trip of the autopilot: ship time, world time, peak gamma, propellant");
    command->group("Fly");
    command->add_option("scenario", options->scenario, "name or .toml (default stars)");
    add_voyage_options(*command, options->voyage);
    command->add_flag("--list", options->list, "list what can be flown to");
    command->add_flag("--json", options->json, "print the forecast as JSON; times in clock units");
    command->callback([options] { plan(*options); });
}

} // namespace engine

#include "engine/commands/commands.h"

#include "content/flight_script.h"
#include "content/scenario.h"
#include "engine/csv_output.h"
#include "engine/flight.h"
#include "engine/flight_columns.h"
#include "engine/flight_table.h"
#include "engine/voyage.h"
#include "sim/bad_input.h"

#include <CLI/Validators.hpp>

#include <array>
#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <optional>

namespace engine {
namespace {

constexpr double lowest_rate = 1e-3;
constexpr double highest_rate = 1e6;
/// Minutes of work; a script that needs more is a slip of the pen.
constexpr double most_steps = 1e10;

struct Options {
    std::string scenario;
    std::string script;
    std::string csv;
    std::optional<double> rate;
    bool exact = false;
    VoyageOptions voyage;
    sim::Tick every = 100;
};

/// Without a scenario.
constexpr double usual_rate = 240.0;

/// A script flies exactly what it says; what the scenario's vehicle cannot do is refused, not cut.
void check_limits(const std::string& file, const sim::FlightScript& script, const sim::VehicleSettings& vehicle,
                  const std::string& clock_unit) {
    const auto refuse = [&](std::size_t segment, const char* what, double value, double limit, const char* unit) {
        throw sim::BadInput(file, fmt::format("segment {}, {}", segment + 1, what), fmt::format("{:g}", value),
                            fmt::format("beyond the vehicle's {:g} {}/{}", limit, unit, clock_unit));
    };
    constexpr std::array thrusts{"ax", "ay", "az"};
    constexpr std::array turns{"wx", "wy", "wz"};
    for (std::size_t i = 0; i < script.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto name = static_cast<std::size_t>(axis);
            if (std::abs(script[i].proper_acceleration[axis]) > vehicle.maximum_acceleration[axis]) {
                refuse(i, thrusts.at(name), script[i].proper_acceleration[axis], vehicle.maximum_acceleration[axis],
                       "c");
            }
            if (std::abs(script[i].angular_velocity[axis]) > vehicle.maximum_turn_rate[axis]) {
                refuse(i, turns.at(name), script[i].angular_velocity[axis], vehicle.maximum_turn_rate[axis], "rad");
            }
        }
    }
}

void check(const Options& options, double rate, const sim::FlightScript& script) {
    if (!(rate >= lowest_rate && rate <= highest_rate)) {
        throw sim::BadInput("--rate", "", fmt::format("{}", rate),
                            fmt::format("must be {} to {} steps per clock unit", lowest_rate, highest_rate));
    }
    double steps = 0.0;
    for (const sim::FlightSegment& segment : script) {
        steps += sim::steps_of_segment(segment, rate);
    }
    if (steps > most_steps) {
        throw sim::BadInput(options.script, "duration", "",
                            fmt::format("the script takes {:.3g} steps, the most is {:.0e}", steps, most_steps));
    }
}

void simulate_script(const Options& options) {
    const sim::FlightScript script = content::load_flight_script(options.script);
    sim::VehicleState state;
    double rate = options.rate.value_or(usual_rate);
    if (!options.scenario.empty()) {
        const content::Scenario scenario = content::load_scenario(options.scenario);
        state = starting_state(scenario);
        rate = options.rate.value_or(scenario.vehicle.tick_rate);
        check_limits(options.script, script, scenario.vehicle, scenario.clock_unit_name);
    }
    check(options, rate, script);

    CsvOutput table{flight_header(), {}};
    for (std::size_t i = 0; i < script.size(); ++i) {
        state = sim::fly_segment(state, script[i], rate, options.exact ? sim::exact_step : sim::step);
        if (!sim::is_in_range(state)) {
            throw sim::BadInput(options.script, fmt::format("segment {}", i + 1), "",
                                fmt::format("takes the ship beyond rapidity {}, the end of what is computed",
                                            sim::largest_rapidity.value));
        }
        auto& row = table.rows.emplace_back();
        for (const double value : flight_values(state)) {
            row.push_back(exact_text(value));
        }
    }
    write_csv(options.csv, table);
    fmt::print("{}: {} segments, ship time {:.6g}, world time {:.6g}, rapidity {:.6g}\n", options.csv, script.size(),
               state.ship_clock.value, state.event.t, sim::rapidity(state.world_from_vehicle).value);
}

/// Flies an autopilot goal, writes its table if asked to, and holds it against the forecast.
void simulate_voyage(const Options& options) {
    content::Scenario scenario = content::load_scenario(options.scenario.empty() ? "stars" : options.scenario);
    if (options.rate) {
        check(options, *options.rate, {});
        scenario.vehicle.tick_rate = *options.rate;
    }
    const Voyage voyage = plan_voyage(scenario, options.voyage);
    std::string table = flight_table_header();
    std::string last;
    const FlownVoyage flown = fly_voyage(voyage, [&](const sim::VehicleState& state) {
        if (options.csv.empty()) {
            return;
        }
        last = state.tick % options.every == 0 ? "" : flight_table_row(state);
        table += state.tick % options.every == 0 ? flight_table_row(state) : "";
    });
    if (!options.csv.empty()) {
        write_text(options.csv, table + last);
    }
    compare_with_plan(voyage, flown);
}

void simulate(const Options& options) {
    if (options.script.empty() == options.voyage.to.empty()) {
        throw sim::BadInput("simulate", "", "",
                            options.script.empty()
                                ? "needs --script or --to: what to fly"
                                : "--script and --to contradict each other: a script or the autopilot flies");
    }
    if (options.exact && options.script.empty()) {
        throw sim::BadInput("--exact", "", "", "is for scripts: the autopilot flies by the simulation's own ticks");
    }
    if (options.voyage.to.empty()) {
        if (options.csv.empty()) {
            throw sim::BadInput("--csv", "", "", "is missing: where a script's table goes");
        }
        simulate_script(options);
    } else {
        simulate_voyage(options);
    }
}

} // namespace

void add_simulate_command(CLI::App& application) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = application.add_subcommand(
        "simulate", "fly a script or the autopilot without pictures\n"
                    "A script (c = 1): writes where each segment ends; each takes exactly its duration, in equal steps "
                    "of at most 1/rate; with a scenario it starts there and keeps to its vehicle's limits.\n"
                    "--to: the autopilot flies there, and the flight is held against the forecast (0.1 %)");
    command->group("Proof");
    command->add_option("--script", options->script, "CSV with columns duration,ax,ay,az,wx,wy,wz (vehicle axes)");
    command->add_option("--csv", options->csv,
                        "CSV to write, with units: tau, t, x, y, z and the tetrad e0_t ... e3_z; with --to every "
                        "field of the state and the instruments");
    command->add_option("--rate", options->rate,
                        "steps per clock unit of ship time (default 240, with a scenario the scenario's)");
    command->add_option("scenario", options->scenario, "where it starts: name or .toml (with --to default stars)");
    command->add_flag("--exact", options->exact,
                      "--script: each step in closed form instead of RK4 (bench observer tells them apart)");
    add_voyage_options(*command, options->voyage);
    command->add_option("--every", options->every, "--to: ticks between two rows of the table")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->callback([options] { simulate(*options); });
}

} // namespace engine

#include "engine/commands/commands.h"

#include "content/flight_script.h"
#include "engine/csv_output.h"
#include "engine/flight_columns.h"
#include "sim/bad_input.h"

#include <cmath>
#include <fmt/core.h>
#include <memory>

namespace engine {
namespace {

constexpr double lowest_rate = 1e-3;
constexpr double highest_rate = 1e6;
/// Minutes of work; a script that needs more is a slip of the pen.
constexpr double most_steps = 1e10;

struct Options {
    std::string script;
    std::string csv;
    double rate = 240.0;
    bool exact = false;
};

void check(const Options& options, const sim::FlightScript& script) {
    if (!(options.rate >= lowest_rate && options.rate <= highest_rate)) {
        throw sim::BadInput("--rate", "", fmt::format("{}", options.rate),
                            fmt::format("must be {} to {} steps per clock unit", lowest_rate, highest_rate));
    }
    double steps = 0.0;
    for (const sim::FlightSegment& segment : script) {
        steps += sim::steps_of_segment(segment, options.rate);
    }
    if (steps > most_steps) {
        throw sim::BadInput(options.script, "duration", "",
                            fmt::format("the script takes {:.3g} steps, the most is {:.0e}", steps, most_steps));
    }
}

void simulate(const Options& options) {
    const sim::FlightScript script = content::load_flight_script(options.script);
    check(options, script);

    CsvOutput table{flight_header(), {}};
    sim::VehicleState state;
    for (std::size_t i = 0; i < script.size(); ++i) {
        state = sim::fly_segment(state, script[i], options.rate, options.exact ? sim::exact_step : sim::step);
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

} // namespace

void add_simulate_command(CLI::App& application) {
    const auto options = std::make_shared<Options>();
    CLI::App* command = application.add_subcommand(
        "simulate", "fly a script without pictures and write where each of its segments ends\n"
                    "c = 1; each segment takes exactly its duration, in equal steps of at most 1/rate");
    command->group("Proof");
    command->add_option("--script", options->script, "CSV with columns duration,ax,ay,az,wx,wy,wz (vehicle axes)")
        ->required();
    command->add_option("--csv", options->csv, "CSV to write, with units: tau, t, x, y, z and the tetrad e0_t ... e3_z")
        ->required();
    command->add_option("--rate", options->rate, "steps per clock unit of ship time")->capture_default_str();
    command->add_flag("--exact", options->exact,
                      "each step in closed form instead of RK4 (bench observer tells them apart)");
    command->callback([options] { simulate(*options); });
}

} // namespace engine

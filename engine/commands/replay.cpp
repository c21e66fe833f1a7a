#include "engine/commands/commands.h"

#include "engine/flight_table.h"
#include "engine/fly/window_flight.h"
#include "engine/recording_file.h"
#include "engine/recording_format.h"
#include "engine/replay.h"
#include "engine/replay_check.h"

#include <CLI/Validators.hpp>

#include <chrono>
#include <fmt/core.h>
#include <memory>
#include <string>

namespace engine {
namespace {

struct ReplayOptions {
    std::string file;
    bool verify = false;
    std::string csv;
    std::string method;
    sim::Tick every = snapshot_interval;
};

/// Ship time of a stretch of ticks, in words.
std::string ship_time(const Recording& recording, sim::Tick ticks) {
    return fmt::format("{:.2f} {} of ship time",
                       static_cast<double>(ticks) / recording.changes.front().vehicle.tick_rate,
                       recording.header.clock_unit_name);
}

void verify(const ReplayOptions& options) {
    const Recording recording = read_recording(options.file);
    const auto start = std::chrono::steady_clock::now();
    const ReplayReport report = fly_again(recording);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    fmt::print("{}: the same flight: {} ticks ({}), {} hashes compared, all equal\n", options.file, report.ticks,
               ship_time(recording, report.ticks), report.hashes);
    if (report.ticks > 0) {
        const double per_second = static_cast<double>(report.ticks) / elapsed.count();
        fmt::print("{:.0f} ticks/s, {:.0f} times as fast as 240 ticks/s\n", per_second, per_second / 240.0);
    }
    if (!recording.ending) {
        fmt::print("the flight was not closed properly: what came after tick {} was never written\n", recording.end());
    }
}

void summarise(const ReplayOptions& options) {
    const Recording recording = read_sound_recording(options.file);
    const sim::Tick ticks = recording.end() - recording.first_tick();
    fmt::print("{}: {}\n", options.file, recording.header.title);
    fmt::print("scenario {}, flown {} with Rapidity {}\n", recording.header.scenario_name, recording.header.started,
               recording.header.program_version);
    fmt::print("{} ticks, {}; {} changes of demand\n", ticks, ship_time(recording, ticks), recording.controls.size());
    for (const FlightChange& change : recording.changes) {
        fmt::print("  tick {}: {}\n", change.state.tick, change.what);
    }
    for (const RecordedEvent& event : recording.events) {
        fmt::print("  tick {}: {}, ship {:.6g} {}, world {:.6g} {}\n", event.tick, event.what, event.ship_clock.value,
                   recording.header.clock_unit_name, event.world_clock.value, recording.header.clock_unit_name);
    }
    for (const std::string& line : changed_inputs(recording.header)) {
        fmt::print(stderr, "rapidity: {}: {}\n", options.file, line);
    }
}

/// In a window; where there is none, in words.
void show(const ReplayOptions& options) {
    summarise(options);
    FlyOptions fly_options;
    if (!options.method.empty()) {
        fly_options.method = named_option("--method", options.method, live_method_names);
    }
    fly_options.replay = options.file;
    try {
        WindowFlight(load_replay(options.file).scenario, fly_options).run();
    } catch (const NoDisplay& error) {
        fmt::print("no window here ({})\n", error.what());
    }
}

void replay(const ReplayOptions& options) {
    if (options.verify) {
        verify(options);
    }
    if (!options.csv.empty()) {
        write_flight_table(read_sound_recording(options.file), options.every, options.csv);
    }
    if (!options.verify && options.csv.empty()) {
        show(options);
    }
}

} // namespace

void add_replay_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("replay", "fly a recorded flight again");
    command->group("Fly");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("file", options->file, "recording, *.rapidity")->required();
    command->add_flag("--verify", options->verify, "without a window: compare with the recorded hashes");
    command->add_option("--method", options->method, "how the window draws: automatic, texture or ray");
    CLI::Option* csv = command->add_option("--csv", options->csv, "without a window: write the flight as a table");
    command->add_option("--every", options->every, "ticks from one row of the table to the next")
        ->check(CLI::Range(sim::Tick{1}, sim::Tick{1} << 53u))
        ->needs(csv)
        ->capture_default_str();
    command->callback([options] { replay(*options); });
}

} // namespace engine

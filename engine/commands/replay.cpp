#include "engine/commands/camera_options.h"
#include "engine/commands/commands.h"
#include "engine/commands/film_options.h"

#include "engine/failure.h"
#include "engine/flight_table.h"
#include "engine/fly/window_flight.h"
#include "engine/option_values.h"
#include "engine/recording_diff.h"
#include "engine/recording_file.h"
#include "engine/recording_format.h"
#include "engine/replay.h"
#include "engine/replay_check.h"
#include "engine/replay_film.h"
#include "sim/bad_input.h"

#include <CLI/Validators.hpp>

#include <chrono>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace engine {
namespace {

struct ReplayOptions {
    std::string file;
    bool verify = false;
    std::string other; ///< to compare with; "": none
    std::string csv;
    std::string method;
    std::string json;
    std::vector<std::string> columns;
    std::string rate;
    sim::Tick every = snapshot_interval;
    bool list_columns = false;
    FilmOptions film;
    CameraOptions camera;
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
    if (!recording.header.origin.empty()) {
        fmt::print("{}\n", recording.header.origin);
    }
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
    fly_options.camera = camera_settings(options.camera);
    fly_options.ghosts = options.camera.ghosts;
    try {
        WindowFlight(load_replay(options.file).scenario, fly_options).run();
    } catch (const NoDisplay& error) {
        fmt::print("no window here ({})\n", error.what());
    }
}

void compare(const ReplayOptions& options) {
    const Recording a = read_sound_recording(options.file);
    const Recording b = read_sound_recording(options.other);
    const RecordingDifference found = difference(a, b);
    if (found.same()) {
        fmt::print("the same flight: {} ticks\n", found.length_a);
        return;
    }
    if (found.demands_part) {
        fmt::print("the demands part at tick {}\n", *found.demands_part);
    }
    if (found.states_part) {
        fmt::print("the states part at tick {}:\n", *found.states_part);
        for (const std::string& field : found.fields) {
            fmt::print("  {}\n", field);
        }
    }
    fmt::print("at tick {}: {:.6g} light {} apart, world clocks {:.6g} {} apart, relative rapidity {:.6g}\n",
               found.until, found.separation, a.header.clock_unit_name, found.world_time_difference,
               a.header.clock_unit_name, found.relative_rapidity.value);
    throw Failure(found.length_a == found.length_b
                      ? fmt::format("{} and {}: not the same flight", options.file, options.other)
                      : fmt::format("{} and {}: not the same flight: {} and {} ticks", options.file, options.other,
                                    found.length_a, found.length_b));
}

void write_tables(const ReplayOptions& options) {
    const Recording recording = read_sound_recording(options.file);
    TableRequest request;
    request.columns = options.columns;
    request.ticks_per_row = static_cast<double>(options.every);
    if (!options.rate.empty()) {
        const double tick_rate = recording.changes.front().vehicle.tick_rate;
        request.ticks_per_row = tick_rate / number_option("--rate", options.rate, 1e-9, 1e9);
    }
    for (const auto& [file, format] : {std::pair{options.csv, TableFormat::csv}, {options.json, TableFormat::json}}) {
        if (!file.empty()) {
            request.format = format;
            write_flight_table(recording, request, file);
        }
    }
}

/// Refuses options that nothing would use.
void check_company(const ReplayOptions& options) {
    if (options.film.without_film()) {
        throw sim::BadInput("replay", "", "", "options of a film need --video or --frames");
    }
    if (options.camera.any() &&
        (options.verify || !options.csv.empty() || !options.json.empty() || !options.other.empty())) {
        throw sim::BadInput("replay", "", "", "cameras and ghosts are for a window or a film");
    }
    if ((!options.columns.empty() || !options.rate.empty()) && options.csv.empty() && options.json.empty()) {
        throw sim::BadInput("replay", "", "", "--columns and --rate need --csv or --json");
    }
}

void replay(const ReplayOptions& options) {
    if (options.list_columns) {
        for (const std::string& line : table_columns()) {
            fmt::print("{}\n", line);
        }
        return;
    }
    if (options.file.empty()) {
        throw sim::BadInput("replay", "", "", "name a recording, *.rapidity");
    }
    check_company(options);
    if (options.verify) {
        verify(options);
    }
    if (options.film.wanted()) {
        FilmRequest request = film_request(options.film, options.method);
        request.camera = camera_settings(options.camera);
        request.ghosts = options.camera.ghosts;
        const Replay replay = load_replay(options.file);
        make_film(replay.scenario, replay_reel(replay, request), request);
    }
    if (!options.csv.empty() || !options.json.empty()) {
        write_tables(options);
    }
    if (!options.other.empty()) {
        compare(options);
    }
    if (!options.verify && options.csv.empty() && options.json.empty() && options.other.empty() &&
        !options.film.wanted()) {
        show(options);
    }
}

} // namespace

void add_replay_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("replay", "fly a recorded flight again");
    command->group("Fly");
    const auto options = std::make_shared<ReplayOptions>();
    command->add_option("file", options->file, "recording, *.rapidity");
    command->add_flag("--verify", options->verify, "without a window: compare with the recorded hashes");
    command->add_option("--method", options->method,
                        "how the window or the film is drawn: automatic, texture or ray; a film also by reference");
    command->add_option("--diff", options->other, "another recording: where and how the two part; exit 1 if they do");
    command->add_option("--csv", options->csv, "without a window: write the flight as a table");
    command->add_option("--json", options->json, "the same as JSON");
    command->add_option("--columns", options->columns, "of the tables: names between commas")->delimiter(',');
    command->add_flag("--list-columns", options->list_columns, "print the names, units and meanings of the columns");
    CLI::Option* every = command->add_option("--every", options->every, "ticks from one row of a table to the next")
                             ->check(CLI::Range(sim::Tick{1}, sim::Tick{1} << 53u))
                             ->capture_default_str();
    command->add_option("--rate", options->rate, "rows per clock unit of ship time, instead of --every")
        ->excludes(every);
    add_film_options(*command, options->film);
    add_camera_options(*command, options->camera);
    command->callback([options] { replay(*options); });
}

} // namespace engine

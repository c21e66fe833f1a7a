#include "engine/commands/bench.h"

#include "engine/recorder.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "engine/replay_deck.h"
#include "engine/temporary_folder.h"
#include "input/demand_grid.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fmt/core.h>
#include <functional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace engine {
namespace {

constexpr double tick_rate = 240.0;
constexpr sim::Tick ticks_per_hour = 864'000;
/// What the recorder writes at once in real time: 0.1 s of flight.
constexpr sim::Tick ticks_per_commit = 24;

using Seconds = std::chrono::duration<double>;
using Clock = std::chrono::steady_clock;

/// Somebody's way of flying.
struct Hand {
    std::string_view name;
    std::function<sim::ControlFrame(sim::Tick, std::mt19937&)> control;
};

/// A demand of an axis whose limit is 1, as the devices' pilot makes it.
double any(std::mt19937& random) {
    return input::on_grid(std::uniform_real_distribution<double>(-1.0, 1.0)(random), 1.0);
}

std::vector<Hand> hands() {
    const auto script = [](sim::Tick tick, std::mt19937&) {
        sim::ControlFrame control;
        control.proper_acceleration.z = (tick / 480) % 2 == 0 ? -1.0 : 1.0;
        control.angular_velocity.y = 0.25;
        return control;
    };
    const auto mouse = [](sim::Tick tick, std::mt19937& random) {
        sim::ControlFrame control;
        control.proper_acceleration.z = (tick / 100) % 2 == 0 ? -1.0 : 1.0;
        control.angular_velocity = {any(random), any(random), 0.0};
        return control;
    };
    const auto all = [](sim::Tick, std::mt19937& random) {
        sim::ControlFrame control;
        control.proper_acceleration = {any(random), any(random), any(random)};
        control.angular_velocity = {any(random), any(random), any(random)};
        return control;
    };
    return {{"script, new thrust every 2 s", script},
            {"mouse that never rests, two axes every tick", mouse},
            {"six analogue axes that never rest", all}};
}

FlightChange start_of_flight() {
    FlightChange start{"start", {}, {}, 1.0};
    start.vehicle.tick_rate = tick_rate;
    return start;
}

/// Writes an hour's flight commit by commit, as the recorder's own thread does. Returns nanoseconds per tick.
double write_an_hour(const std::filesystem::path& file, const Hand& hand) {
    const FlightChange start = start_of_flight();
    RecordingWriter writer(file, {}, start);
    std::mt19937 random(1);
    FlightBatch batch;
    batch.latest = start.state;
    sim::ControlFrame before;
    Seconds writing{0};
    for (sim::Tick tick = 0; tick < ticks_per_hour; ++tick) {
        const sim::ControlFrame control = hand.control(tick, random);
        if (!identical(control, before)) {
            batch.controls.push_back({tick, control});
            before = control;
        }
        batch.latest = sim::advance(batch.latest, start.vehicle, control);
        if (batch.latest.tick % snapshot_interval == 0) {
            batch.snapshots.push_back(batch.latest);
        }
        if (batch.latest.tick % ticks_per_commit == 0) {
            const auto begin = Clock::now();
            writer.write(batch);
            writing += Clock::now() - begin;
            batch.controls.clear();
            batch.snapshots.clear();
        }
    }
    writer.finish(batch.latest.tick);
    return 1e9 * writing.count() / static_cast<double>(ticks_per_hour);
}

/// Nanoseconds that telling the recorder of a tick takes the flight's thread.
double cost_on_the_flights_thread(const std::filesystem::path& file, const Hand& hand) {
    constexpr std::size_t ticks = 120'000;
    const FlightChange start = start_of_flight();
    std::mt19937 random(1);
    std::vector<sim::ControlFrame> controls;
    std::vector<sim::VehicleState> states{start.state};
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        controls.push_back(hand.control(tick, random));
        states.push_back(sim::advance(states.back(), start.vehicle, controls.back()));
    }
    Recorder recorder(file, {}, start);
    const auto begin = Clock::now();
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        recorder.on_tick(controls[tick], states[tick + 1]);
    }
    return 1e9 * Seconds(Clock::now() - begin).count() / static_cast<double>(ticks);
}

struct SeekTimes {
    double median = 0.0; ///< milliseconds
    double worst = 0.0;  ///< milliseconds
};

/// Goes to random moments of a recording.
SeekTimes time_seeks(const Recording& recording) {
    ReplayDeck deck(recording);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(static_cast<double>(deck.first()), static_cast<double>(deck.end()));
    std::vector<double> milliseconds;
    for (int i = 0; i < 1000; ++i) {
        const double position = anywhere(random);
        const auto begin = Clock::now();
        deck.seek(position);
        milliseconds.push_back(1e3 * Seconds(Clock::now() - begin).count());
    }
    std::sort(milliseconds.begin(), milliseconds.end());
    return {milliseconds[milliseconds.size() / 2], milliseconds.back()};
}

void bench_recording() {
    const TemporaryFolder folder;
    for (const Hand& hand : hands()) {
        const auto file = folder / "hour.rapidity";
        const double writing = write_an_hour(file, hand);
        const double telling = cost_on_the_flights_thread(folder / "tell.rapidity", hand);
        const auto begin = Clock::now();
        const Recording recording = read_recording(file);
        const Seconds reading = Clock::now() - begin;
        const ReplayReport report = fly_again(recording);
        const Seconds flying = Clock::now() - begin - reading;
        fmt::print("an hour of flight at {:.0f} ticks/s: {}\n", tick_rate, hand.name);
        fmt::print("  file {:.2f} MB; flight's thread {:.0f} ns a tick, writer's thread {:.0f} ns a tick\n",
                   1e-6 * static_cast<double>(std::filesystem::file_size(file)), telling, writing);
        fmt::print("  read in {:.2f} s, flown again in {:.2f} s: {:.0f} times real time, {} hashes equal\n",
                   reading.count(), flying.count(), 3600.0 / flying.count(), report.hashes);
        const SeekTimes seeks = time_seeks(recording);
        fmt::print("  seek: median {:.3f} ms, longest of 1000 {:.3f} ms\n", seeks.median, seeks.worst);
        std::filesystem::remove(file);
        std::filesystem::remove(folder / "tell.rapidity");
    }
}

} // namespace

void add_bench_recording(CLI::App& bench) {
    bench.add_subcommand("recording", "size of an hour's recording, and what recording and replaying cost")
        ->callback(bench_recording);
}

} // namespace engine

#include "engine/commands/bench.h"

#include "sim/vehicle.h"

#include <algorithm>
#include <ctime>
#include <fmt/core.h>
#include <vector>

namespace engine {
namespace {

constexpr int ticks_per_repetition = 20000;
constexpr int repetitions = 101;

/// Nanoseconds of processor time per tick of one stretch of flight that turns and thrusts about every axis.
double nanoseconds_per_tick(const sim::VehicleSettings& settings, double& rapidity_reached) {
    sim::VehicleState state;
    sim::ControlFrame control;
    const std::clock_t start = std::clock();
    for (int i = 0; i < ticks_per_repetition; ++i) {
        const double way = (i / 480) % 2 == 0 ? 1.0 : -1.0;
        control.proper_acceleration = {0.3 * way, -0.2 * way, way};
        control.angular_velocity = {0.1, 0.7 * way, -0.4};
        state = sim::advance(state, settings, control);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    rapidity_reached = sim::rapidity(state.world_from_vehicle).value;
    return seconds * 1e9 / ticks_per_repetition;
}

void bench_tick() {
    const sim::VehicleSettings settings;
    double rapidity_reached = 0.0;
    std::vector<double> times;
    times.reserve(repetitions);
    for (int i = 0; i < repetitions; ++i) {
        times.push_back(nanoseconds_per_tick(settings, rapidity_reached));
    }
    std::sort(times.begin(), times.end());
    fmt::print("one simulation tick, processor time: median {:.0f} ns, fastest {:.0f} ns, slowest {:.0f} ns ({} runs "
               "of {} ticks)\n",
               times[times.size() / 2], times.front(), times.back(), repetitions, ticks_per_repetition);
    fmt::print("the flight tumbles from rest to rapidity {:.2f}\n", rapidity_reached);
}

} // namespace

void add_bench_tick(CLI::App& bench) {
    bench.add_subcommand("tick", "time of one simulation tick")->callback(bench_tick);
}

} // namespace engine

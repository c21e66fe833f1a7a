#pragma once

#include <CLI/App.hpp>

/// `rapidity bench X`: measurements that print numbers. One function and one file each (engine/commands/bench_x.cpp),
/// called by add_bench_command.
namespace engine {

/// `bench tick`: the time one simulation tick takes.
void add_bench_tick(CLI::App& bench);

/// `bench recording`: size of an hour's recording, and the time that recording and replaying take.
void add_bench_recording(CLI::App& bench);

/// `bench white`: whether colours come out as they went in where nothing moves.
void add_bench_white(CLI::App& bench);

/// `bench pictures`: sharpness and edges of the texture method against the supersampled reference.
void add_bench_pictures(CLI::App& bench);

} // namespace engine

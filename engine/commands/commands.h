#pragma once

#include <CLI/App.hpp>

/// One function a verb: adds the subcommand with its options, and the callback that does the work. Callbacks throw
/// sim::BadInput for bad input (exit 2), engine::Failure for a comparison not met (exit 1).
namespace engine {

void add_version_command(CLI::App& application);
void add_doctor_command(CLI::App& application);
void add_fly_command(CLI::App& application);
void add_bench_command(CLI::App& application);
void add_simulate_command(CLI::App& application);
void add_plan_command(CLI::App& application);
void add_verify_command(CLI::App& application);
void add_scenes_command(CLI::App& application);
void add_import_stars_command(CLI::App& application);
void add_replay_command(CLI::App& application);
void add_film_command(CLI::App& application);
void add_recover_command(CLI::App& application);
void add_generate_command(CLI::App& application);
void add_geodesic_command(CLI::App& application);
void add_spacetimes_command(CLI::App& application);

/// `rapidity render`: one picture.
void add_render_command(CLI::App& application);
/// `rapidity probe`: the spectrum at a point of such a picture.
void add_probe_command(CLI::App& application);

/// `rapidity trace`: pictures and sequences of curved spacetimes.
void add_trace_command(CLI::App& application);

} // namespace engine

#pragma once

#include <CLI/App.hpp>

/// `rapidity bench X`: measurements that print numbers. One function and one file each (engine/commands/bench_x.cpp),
/// called by add_bench_command.
namespace engine {

/// `bench tick`: the time one simulation tick takes.
void add_bench_tick(CLI::App& bench);

/// `bench observer`: speed against error of the ship's integrator and of others.
void add_bench_observer(CLI::App& bench);

/// `bench hard-cases`: flights that are hard on an integrator, against closed forms; fails when one is off.
void add_bench_hard_cases(CLI::App& bench);

/// `bench recording`: size of an hour's recording, and the time that recording and replaying take.
void add_bench_recording(CLI::App& bench);

/// `bench white`: whether colours come out as they went in where nothing moves.
void add_bench_white(CLI::App& bench);

/// `bench pictures`: sharpness and edges of the live methods against the supersampled reference.
void add_bench_pictures(CLI::App& bench);

/// `bench frame`: what a frame of a moving eye costs against one of an eye at rest, stage by stage.
void add_bench_frame(CLI::App& bench);

/// `bench cockpit`: what cabin, its light and its screens cost on top of a picture.
void add_bench_cockpit(CLI::App& bench);

/// `bench warp`: the largest errors of the warp shader against double precision; fails above 0.1 px or 1e-4 of D.
void add_bench_warp(CLI::App& bench);

/// `bench geodesics`: rays of light a second against their error, kernel by kernel.
void add_bench_geodesics(CLI::App& bench);

/// `bench colour`: the colour tables' build time and error, spectra of RGB reflectances against measured ones, and what
/// full colour adds to a frame; fails above 0.5 % of table error.
void add_bench_colour(CLI::App& bench);

/// `bench light`: radiance, flux and whole-sky sums of moving eyes' pictures against closed forms; fails above
/// tolerance.
void add_bench_light(CLI::App& bench);

/// `bench vr`: what a stereo frame costs, what both eyes share, and how old the head's place is when its picture is
/// handed over.
void add_bench_vr(CLI::App& bench);

} // namespace engine

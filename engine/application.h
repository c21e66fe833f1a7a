#pragma once

#include <CLI/App.hpp>

namespace engine {

/// Runs the program on a command line; returns the exit code: 0 done, 1 a failure or a comparison not met, 2 bad usage
/// or input. The one place where exceptions end: each prints one line.
int run_application(int argc, const char* const* argv);

} // namespace engine

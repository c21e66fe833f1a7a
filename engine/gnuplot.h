#pragma once

#include <string>

namespace engine {

/// Whether the program gnuplot, which draws plots, is installed.
bool has_gnuplot();

/// Runs a gnuplot script. Throws Failure in one line when gnuplot is not installed or objects.
void run_gnuplot(const std::string& script);

/// A text as gnuplot quotes it.
std::string gnuplot_text(const std::string& text);

} // namespace engine

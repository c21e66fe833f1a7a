#pragma once

#include "render/offline/spectrum_probe.h"

#include <string>

namespace engine {

/// gnuplot's script for an SVG file of a probed light's spectrum, as the instruments plot it: both scales logarithmic,
/// 100 nm to 10 um; emitted and received; the visible in its colours, and along the foot the same colours where they
/// were emitted.
std::string probe_plot_script(const std::string& file, const render::ProbedLight& light);

} // namespace engine

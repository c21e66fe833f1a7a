#pragma once

#include "render/offline/spectrum_probe.h"

#include <string>
#include <vector>

namespace engine {

/// What the CIE 1931 observer sees, nm.
inline constexpr double first_visible_nm = 380.0;
inline constexpr double last_visible_nm = 750.0;

/// What a probe found, in short lines: source, D, colours at rest and as seen, where both spectra peak.
std::vector<std::string> probe_lines(const render::ProbedLight& light);

/// What a probe's spectral radiance is told in.
std::string radiance_unit(const render::ProbedLight& light);

/// Wavelength in [100 nm, 10 um] at which a spectrum is strongest, to 0.1 %; 0 where it is dark.
double peak_nm(const std::function<double(double)>& spectrum);

} // namespace engine

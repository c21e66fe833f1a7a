#pragma once

#include "render/offline/spectrum_probe.h"

#include <glm/vec3.hpp>

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

/// Roughly what a pure wavelength looks like, sRGB in 0 to 1; black out of sight.
glm::vec3 pure_colour(double nm);

/// A plot's vertical scale: whole powers of ten, the uppermost not below the largest value.
struct RadianceAxis {
    static constexpr int decades = 6;

    explicit RadianceAxis(double largest);

    /// How high a value lies, 0 to 1; what is below the scale, or dark, at 0.
    double height(double value) const;
    /// "1", "0.01", "1e-6": the value `below` powers of ten under the uppermost.
    std::string label(int below) const;

    int top_exponent;
};

/// Wavelength in [100 nm, 10 um] at which a spectrum is strongest, to 0.1 %; 0 where it is dark.
double peak_nm(const std::function<double(double)>& spectrum);

} // namespace engine

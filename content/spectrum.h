#pragma once

#include <vector>

namespace content {

/// A spectrum on an even wavelength grid, linear between its samples.
struct TabulatedSpectrum {
    enum class Beyond { zero, held }; ///< what lies outside the grid: nothing, or the value at its end

    double first_nm = 0.0;
    double step_nm = 1.0; ///< > 0
    std::vector<double> values;
    Beyond beyond = Beyond::zero;

    double at(double wavelength_nm) const;
};

/// Second radiation constant h c / k, nm K (CODATA 2018, exact).
inline constexpr double second_radiation_constant_nm_kelvin = 1.438776877e7;

/// First radiation constant for radiance 2 h c^2, W m^2 sr^-1 (CODATA 2018, exact).
inline constexpr double first_radiation_constant = 1.191042972e-16;

/// Planck's spectral radiance of a black body, W sr^-1 m^-2 per metre of wavelength. Temperature > 0; underflows to 0
/// far in the Wien tail.
double black_body_radiance(double wavelength_nm, double temperature_kelvin);

} // namespace content

#pragma once

#include "sim/readings.h"

#include <string>

/// Instrument values as text. Every figure shown is one that the value has; none jumps between formats from one frame
/// to the next without its value crossing a threshold.
namespace engine {

/// beta with as many nines as it takes, then "1 - 4.1e-17".
std::string beta_text(const sim::Readings& readings);

/// gamma; "1 + 3.2e-05" near rest.
std::string gamma_text(const sim::Readings& readings);

/// Rapidity, dimensionless.
std::string rapidity_text(sim::Rapidity rapidity);

/// A clock in its unit: "12.34 s", "1.0345 yr".
std::string clock_text(double value, const std::string& unit);

/// A distance in light clock units: "4.394 light-years", "8.43 light-seconds".
std::string distance_text(double value, const std::string& clock_unit);

/// D = lambda_observed / lambda_emitted: "0.142", "7.09".
std::string wavelength_ratio_text(double ratio);

/// Felt acceleration in g (9.80665 m/s^2): "1.02 g", "3.1e+07 g".
std::string g_text(double acceleration_in_g);

/// c per clock unit to g.
double g_from_acceleration(double acceleration, double speed_of_light, double clock_unit_seconds);

} // namespace engine

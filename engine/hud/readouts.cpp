#include "engine/hud/readouts.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace engine {
namespace {

constexpr double standard_gravity = 9.80665; ///< m/s^2

/// Three significant figures where that is short, powers of ten elsewhere.
std::string three_figures(double value) {
    const double magnitude = std::abs(value);
    if (magnitude != 0.0 && (magnitude < 0.001 || magnitude >= 99999.5)) {
        return fmt::format("{:.1e}", value);
    }
    const int decimals = magnitude >= 99.95 ? 0 : magnitude >= 9.995 ? 1 : magnitude >= 0.9995 ? 2 : 3;
    return fmt::format("{:.{}f}", value, decimals);
}

} // namespace

std::string beta_text(const sim::Readings& readings) {
    constexpr int fewest = 4;
    constexpr int most = 10;
    const double rest = readings.one_minus_beta;
    const int decimals = rest > 0.0 ? static_cast<int>(std::ceil(-std::log10(rest))) + 1 : most + 1;
    if (decimals > most) {
        return fmt::format("1 - {:.1e}", rest);
    }
    // The digits of beta are those of 1 - beta: cut off, not rounded, so that 0.99995 never reads 1.0000.
    const double scale = std::pow(10.0, std::max(decimals, fewest));
    const double shown = (scale - std::ceil(rest * scale - 1e-6)) / scale;
    return fmt::format("{:.{}f}", std::max(shown, 0.0), std::max(decimals, fewest));
}

std::string gamma_text(const sim::Readings& readings) {
    if (readings.gamma_minus_one > 0.0 && readings.gamma_minus_one < 0.0005) {
        return fmt::format("1 + {:.1e}", readings.gamma_minus_one);
    }
    return readings.gamma < 99.9995   ? fmt::format("{:.3f}", readings.gamma)
           : readings.gamma < 99999.5 ? fmt::format("{:.0f}", readings.gamma)
                                      : fmt::format("{:.2e}", readings.gamma);
}

std::string rapidity_text(sim::Rapidity rapidity) {
    return fmt::format("{:.3f}", rapidity.value);
}

std::string clock_text(double value, const std::string& unit) {
    const double magnitude = std::abs(value);
    const int decimals = magnitude < 99.995 ? (unit == "s" ? 2 : 4) : magnitude < 99999.5 ? 1 : -1;
    return decimals >= 0 ? fmt::format("{:.{}f} {}", value, decimals, unit) : fmt::format("{:.4e} {}", value, unit);
}

std::string distance_text(double value, const std::string& clock_unit) {
    return fmt::format("{:.4g} light-{}", value,
                       clock_unit == "yr"  ? "years"
                       : clock_unit == "s" ? "seconds"
                                           : clock_unit);
}

std::string wavelength_ratio_text(double ratio) {
    return three_figures(ratio);
}

std::string g_text(double acceleration_in_g) {
    return (acceleration_in_g < 0.0005 ? std::string("0") : three_figures(acceleration_in_g)) + " g";
}

double g_from_acceleration(double acceleration, double speed_of_light, double clock_unit_seconds) {
    return acceleration * speed_of_light / (clock_unit_seconds * standard_gravity);
}

} // namespace engine

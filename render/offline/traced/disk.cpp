#include "render/offline/traced/disk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace render {
namespace disk {

double innermost_stable_radius(double spin) {
    const double z1 = 1.0 + std::cbrt(1.0 - spin * spin) * (std::cbrt(1.0 + spin) + std::cbrt(1.0 - spin));
    const double z2 = std::sqrt(3.0 * spin * spin + z1 * z1);
    const double root = std::sqrt(std::max(0.0, (3.0 - z1) * (3.0 + z1 + 2.0 * z2)));
    return 3.0 + z2 - std::copysign(root, spin);
}

double angular_velocity(double spin, double r) {
    return 1.0 / (r * std::sqrt(r) + spin);
}

double time_dilation(double spin, double r) {
    const double v3 = 1.0 / (r * std::sqrt(r));
    return (1.0 + spin * v3) / std::sqrt(1.0 - 3.0 / r + 2.0 * spin * v3);
}

double emitted_over_infinity(double spin, double r, double impact_parameter) {
    return time_dilation(spin, r) * (1.0 - angular_velocity(spin, r) * impact_parameter);
}

double flux(double spin, double r) {
    const double r0 = innermost_stable_radius(spin);
    if (r <= r0) {
        return 0.0;
    }
    // x = sqrt(r); x1, x2, x3 are the roots of x^3 - 3x + 2a.
    const double x = std::sqrt(r);
    const double x0 = std::sqrt(r0);
    const double angle = std::acos(spin) / 3.0;
    const std::array<double, 3> root{2.0 * std::cos(angle - std::numbers::pi / 3.0),
                                     2.0 * std::cos(angle + std::numbers::pi / 3.0), -2.0 * std::cos(angle)};
    double bracket = x - x0 - 1.5 * spin * std::log(x / x0);
    for (std::size_t i = 0; i < 3; ++i) {
        const double own = root[i];
        const double second = root[(i + 1) % 3];
        const double third = root[(i + 2) % 3];
        // At a = 0 one root is 0 and its term vanishes with (x_i - a)^2 / x_i.
        const double weight =
            own == 0.0 ? 0.0 : 3.0 * (own - spin) * (own - spin) / (own * (own - second) * (own - third));
        bracket -= weight * std::log((x - own) / (x0 - own));
    }
    return 1.5 / (x * x * x * x * (x * x * x - 3.0 * x + 2.0 * spin)) * bracket;
}

} // namespace disk

namespace {

constexpr std::size_t samples = 2048;
constexpr double ln_extent = 9.0; // up to 8,000 times the innermost stable radius

} // namespace

DiskTemperature::DiskTemperature(double spin, double peak_temperature)
    : inner_(disk::innermost_stable_radius(spin)), values_(samples) {
    for (std::size_t i = 0; i < samples; ++i) {
        const double r = inner_ * std::exp(ln_extent * static_cast<double>(i) / (samples - 1));
        values_[i] = std::pow(std::max(0.0, disk::flux(spin, r)), 0.25);
    }
    const double largest = *std::max_element(values_.begin(), values_.end());
    for (double& value : values_) {
        value *= peak_temperature / largest;
    }
}

double DiskTemperature::at(double r) const {
    if (!(r > inner_)) {
        return 0.0;
    }
    const double position = std::log(r / inner_) / ln_extent * (samples - 1);
    const auto i = static_cast<std::size_t>(position);
    if (i >= samples - 1) {
        return values_.back() * std::pow(inner_ * std::exp(ln_extent) / r, 0.75);
    }
    return values_[i] + (position - static_cast<double>(i)) * (values_[i + 1] - values_[i]);
}

} // namespace render

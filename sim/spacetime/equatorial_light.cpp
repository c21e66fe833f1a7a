#include "sim/spacetime/equatorial_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace sim {
namespace {

using std::numbers::pi;

/// Gauss and Legendre's rule on [-1, 1].
struct GaussRule {
    static constexpr int order = 16;
    std::array<double, order> node{};
    std::array<double, order> weight{};

    GaussRule() {
        for (int i = 0; i < order; ++i) {
            double x = std::cos(pi * (i + 0.75) / (order + 0.5));
            double slope = 1.0;
            for (int step = 0; step < 8; ++step) { // Newton's, on P_16
                double before = 1.0, p = x;
                for (int n = 2; n <= order; ++n) {
                    const double next = ((2.0 * n - 1.0) * x * p - (n - 1.0) * before) / n;
                    before = p;
                    p = next;
                }
                slope = order * (before - x * p) / (1.0 - x * x);
                x -= p / slope;
            }
            node[static_cast<std::size_t>(i)] = x;
            weight[static_cast<std::size_t>(i)] = 2.0 / ((1.0 - x * x) * slope * slope);
        }
    }
};

template <class Function>
double integral(double from, double to, int panels, const Function& f) {
    static const GaussRule rule;
    const double half = 0.5 * (to - from) / panels;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = from + half * (2.0 * panel + 1.0);
        for (std::size_t i = 0; i < GaussRule::order; ++i) {
            sum += rule.weight[i] * f(middle + half * rule.node[i]);
        }
    }
    return half * sum;
}

} // namespace

double carlson_rf(double x, double y, double z) {
    // Duplication brings the three together; the rest is a series in their small differences, of relative error 3e-16.
    double mean = (x + y + z) / 3.0;
    double spread = std::max({std::abs(mean - x), std::abs(mean - y), std::abs(mean - z)});
    const auto apart = [&] { return spread > 1e-3 * mean; };
    while (apart()) {
        const double lambda = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
        mean = (x + y + z) / 3.0;
        spread *= 0.25;
    }
    const double dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -dx - dy;
    const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
    return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) / std::sqrt(mean);
}

double equatorial_sweep(double spin, double impact, double radius) {
    // Periapsis and the other roots of r^3 - p r + s = 0, by the trisection of an angle.
    const double p = impact * impact - spin * spin;
    const double s = 2.0 * (impact - spin) * (impact - spin);
    const double cosine = -1.5 * s / p * std::sqrt(3.0 / p);
    if (!(cosine > -1.0)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const auto root = [&](int k) {
        return 2.0 * std::sqrt(p / 3.0) * std::cos((std::acos(cosine) - 2.0 * pi * k) / 3.0);
    };
    std::array<double, 3> u{1.0 / root(0), 1.0 / root(1), 1.0 / root(2)};
    std::ranges::sort(u);
    const double below = u[1] - u[0], all = u[2] - u[0];
    const double modulus2 = below / all;
    // u = u_1 + (u_2 - u_1) sin^2 theta.
    const auto rate = [&](double theta) {
        const double sine2 = std::sin(theta) * std::sin(theta);
        const double here = u[0] + below * sine2;
        const double turning =
            impact - spin +
            spin * (1.0 + spin * (spin - impact) * here * here) / (1.0 - 2.0 * here + spin * spin * here * here);
        return turning / std::sqrt(1.0 - modulus2 * sine2);
    };
    const auto leg = [&](double from) {
        return integral(std::asin(std::sqrt((from - u[0]) / below)), 0.5 * pi, 32, rate);
    };
    return 2.0 / std::sqrt(s * all) * (leg(1.0 / radius) + leg(0.0));
}

} // namespace sim

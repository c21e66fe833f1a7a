#include "render/offline/traced/disk.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
namespace disk = render::disk;

namespace {

// Energy and angular momentum of a unit mass on the circular orbit (Bardeen, Press & Teukolsky 1972, eqs 2.12, 2.13).
double energy(double a, double r) {
    const double x = std::sqrt(r);
    return (r * x - 2.0 * x + a) / (std::pow(r, 0.75) * std::sqrt(r * x - 3.0 * x + 2.0 * a));
}
double angular_momentum(double a, double r) {
    const double x = std::sqrt(r);
    return (r * r - 2.0 * a * x + a * a) / (std::pow(r, 0.75) * std::sqrt(r * x - 3.0 * x + 2.0 * a));
}

/// Page & Thorne's integral, eq. 11b, by the trapezoidal rule: -(dOmega/dr) / (E - Omega L)^2 / r times the integral
/// of (E - Omega L) dL from the innermost orbit.
double flux_by_integration(double a, double r) {
    constexpr int steps = 200000;
    const double inner = disk::innermost_stable_radius(a);
    const auto share = [&](double s) { return energy(a, s) - disk::angular_velocity(a, s) * angular_momentum(a, s); };
    double integral = 0.0;
    double l_before = angular_momentum(a, inner);
    double share_before = share(inner);
    for (int i = 1; i <= steps; ++i) {
        const double s = inner + (r - inner) * i / steps;
        const double l = angular_momentum(a, s);
        const double now = share(s);
        integral += 0.5 * (now + share_before) * (l - l_before);
        l_before = l;
        share_before = now;
    }
    const double omega = disk::angular_velocity(a, r);
    const double omega_slope = -1.5 * std::sqrt(r) * omega * omega;
    return -omega_slope / (share(r) * share(r)) / r * integral;
}

} // namespace

TEST_CASE("the innermost stable orbit is at the radii that are known") {
    CHECK_THAT(disk::innermost_stable_radius(0.0), WithinAbs(6.0, 1e-12));
    CHECK_THAT(disk::innermost_stable_radius(-0.998), WithinAbs(8.994, 1e-3));
    CHECK_THAT(disk::innermost_stable_radius(0.998), WithinAbs(1.2370, 1e-4)); // Thorne 1974
    // It is where the orbit's energy is least.
    for (const double a : {-0.9, 0.0, 0.5, 0.99}) {
        const double r = disk::innermost_stable_radius(a);
        const double h = 1e-4 * r;
        CHECK(energy(a, r) < energy(a, r - h));
        CHECK(energy(a, r) < energy(a, r + h));
    }
}

TEST_CASE("matter on a circular orbit around Schwarzschild runs slow by sqrt(1 - 3 M/r)") {
    for (const double r : {6.0, 10.0, 1000.0}) {
        CHECK_THAT(disk::time_dilation(0.0, r), WithinRel(1.0 / std::sqrt(1.0 - 3.0 / r), 1e-14));
        CHECK_THAT(disk::angular_velocity(0.0, r), WithinRel(std::pow(r, -1.5), 1e-14));
    }
    // Light that leaves at right angles to the motion has the time dilation alone.
    CHECK_THAT(disk::emitted_over_infinity(0.9, 8.0, 0.0), WithinRel(disk::time_dilation(0.9, 8.0), 1e-15));
}

TEST_CASE("the disk's flux is Page and Thorne's integral") {
    for (const double a : {-0.7, 0.0, 0.9, 0.99}) {
        const double inner = disk::innermost_stable_radius(a);
        for (const double r : {1.2 * inner, 2.0 * inner, 10.0 * inner}) {
            INFO("a = " << a << ", r = " << r);
            // The trapezoids' error is 1e-9; the closed form cancels to about 1e-13 of its terms.
            CHECK_THAT(disk::flux(a, r), WithinRel(flux_by_integration(a, r), 1e-6));
        }
        CHECK(disk::flux(a, 0.99 * inner) == 0.0);
    }
}

TEST_CASE("a disk's temperature has its peak where asked and falls as r^(-3/4) far out") {
    const render::DiskTemperature temperature(0.0, 10000.0);
    double hottest = 0.0;
    double where = 0.0;
    for (double r = 6.0; r < 30.0; r += 0.01) {
        if (temperature.at(r) > hottest) {
            hottest = temperature.at(r);
            where = r;
        }
    }
    CHECK_THAT(hottest, WithinRel(10000.0, 1e-4));
    CHECK_THAT(where, WithinAbs(9.55, 0.05)); // the known maximum of Page & Thorne's flux at a = 0
    // Newton's disk has T^4 ~ r^-3 (1 - sqrt(r_i/r)); relativity changes the root's factor, a few per cent at r = 5000.
    const auto newton = [](double r) { return std::pow(r, -0.75) * std::pow(1.0 - std::sqrt(6.0 / r), 0.25); };
    CHECK_THAT(temperature.at(20000.0) / temperature.at(5000.0), WithinRel(newton(20000.0) / newton(5000.0), 5e-3));
    CHECK(temperature.at(5.9) == 0.0);
}

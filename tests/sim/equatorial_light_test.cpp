#include "sim/spacetime/equatorial_light.h"

#include "sim/spacetime/bundle.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/schwarzschild.h"

#include <catch2/catch_test_macros.hpp>

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

using std::numbers::pi;

namespace {

/// Twice the way from infinity to periapsis, less a straight line.
double deflection(double spin, double impact) {
    return std::abs(sim::equatorial_sweep(spin, impact, 1e300)) - pi;
}

} // namespace

TEST_CASE("the sweep of equatorial light is the tables'") {
    // reference/schwarzschild_static_observer.csv, r = 10, and kerr_equatorial_deflection.csv: 18 digits each.
    const auto impact = [](double psi) { return 10.0 * std::sin(psi) / std::sqrt(0.8); };
    CHECK(std::abs(sim::equatorial_sweep(0.0, impact(0.6), 10.0) - 3.93313517446859391) < 1e-13);
    CHECK(std::abs(sim::equatorial_sweep(0.0, impact(1.0), 10.0) - 2.66000410131596271) < 1e-13);
    CHECK(std::abs(deflection(0.9, 4.0) - 2.17829044890708252) < 1e-13);
    CHECK(std::abs(deflection(0.9, -8.0) - 1.25329386613008109) < 1e-13);
    CHECK(std::abs(deflection(0.99, 3.0) - 3.9751518074329174) < 1e-13);
    CHECK(std::abs(deflection(0.99, -10.0) - 0.737541862461284348) < 1e-13);
    CHECK(std::isnan(sim::equatorial_sweep(0.0, 5.19, 100.0)));
    CHECK(std::isnan(sim::equatorial_sweep(0.9, 2.8, 100.0)));
}

TEST_CASE("without spin the sweep is Carlson's elliptic integral of the first kind") {
    // Abramowitz & Stegun 17.2: K(m = 1/2) = R_F(0, 1/2, 1).
    CHECK(std::abs(sim::carlson_rf(0.0, 0.5, 1.0) - 1.85407467730137192) < 1e-15);
    CHECK(std::abs(sim::carlson_rf(2.0, 2.0, 2.0) - 1.0 / std::sqrt(2.0)) < 1e-15);
    // Periapsis P (Darwin 1959): b^2 = P^3/(P - 2), the roots of 1/b^2 - u^2 + 2 u^3 are 1/P and
    // (P - 2 -+ sqrt((P - 2)(P + 6)))/(4 P).
    for (const double periapsis : {3.01, 3.5, 6.0, 50.0}) {
        const double root = std::sqrt((periapsis - 2.0) * (periapsis + 6.0));
        const double u1 = (periapsis - 2.0 - root) / (4.0 * periapsis), u2 = 1.0 / periapsis;
        const double u3 = (periapsis - 2.0 + root) / (4.0 * periapsis);
        const double modulus2 = (u2 - u1) / (u3 - u1);
        const double sine2 = -u1 / (u2 - u1);
        const double whole = sim::carlson_rf(0.0, 1.0 - modulus2, 1.0);
        const double part = std::sqrt(sine2) * sim::carlson_rf(1.0 - sine2, 1.0 - modulus2 * sine2, 1.0);
        const double swept = 4.0 / std::sqrt(2.0 * (u3 - u1)) * (whole - part);
        const double impact = std::sqrt(periapsis * periapsis * periapsis / (periapsis - 2.0));
        // At 3.01 the impact is 1 + 2e-5 of the critical one: a rounding of it moves the sweep by 1e5 roundings.
        CHECK(std::abs(sim::equatorial_sweep(0.0, impact, 1e300) / swept - 1.0) < 1e-11);
    }
}

TEST_CASE("a bundle's magnification is that of the elliptic integral's derivative") {
    // An eye at rest at r sees at the angle psi from the hole what lies at the angle Theta(psi) from behind it:
    // mu = |sin(psi) dpsi/(sin(Theta) dTheta)|.
    const sim::Schwarzschild hole(1.0);
    const double r = 12.0;
    const sim::Components<double> place{0.0, r, 0.0, 0.0};
    const auto rest = sim::observer_velocity(hole, place, sim::ObserverKind::at_rest);
    const auto eye = sim::camera_tetrad(hole, place, rest.value(), {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    const auto swept = [&](double psi) {
        return sim::equatorial_sweep(0.0, r * std::sin(psi) / std::sqrt(1.0 - 2.0 / r), r);
    };
    for (const double psi : {0.45, 0.5, 0.7, 1.2}) {
        // Central differences of order 8: h^8 times the ninth derivative, which the ring at psi = 0.41 raises to 1e14.
        const double h = 5e-4;
        const auto difference = [&](int k) { return swept(psi + k * h) - swept(psi - k * h); };
        const double slope =
            (0.8 * difference(1) - 0.2 * difference(2) + 4.0 / 105.0 * difference(3) - difference(4) / 280.0) / h;
        const double expected = std::abs(std::sin(psi) / (std::sin(swept(psi)) * slope));
        sim::RaySettings settings;
        settings.step = 0.005;
        const auto bundle = sim::trace_bundle(hole, place, eye, {std::sin(psi), 0.0, -std::cos(psi)}, settings);
        INFO("psi " << psi << ", magnification " << expected);
        REQUIRE(bundle.ray.outcome == sim::RayOutcome::escaped);
        CHECK(std::abs(bundle.magnification() / expected - 1.0) < 1e-7);
        // An image whose light went round by pi to 2 pi is mirrored, as the first one on the hole's other side is.
        CHECK(bundle.mirrored() == (std::sin(swept(psi)) * slope > 0.0));
    }
}

#include "sim/exact_step.h"
#include "sim/integrators.h"
#include "sim/vehicle.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <functional>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

sim::Drive drive(const glm::dvec3& a, const glm::dvec3& w) {
    return {a, w};
}

/// The largest entry of the difference of two Lambdas.
double apart(const sim::SpinMatrix& p, const sim::SpinMatrix& q) {
    const sim::SpinMatrix d = p - q;
    return std::sqrt(std::max({norm2(d.a), norm2(d.b), norm2(d.c), norm2(d.d)}));
}

double apart(const sim::Event& p, const sim::Event& q) {
    return std::max(std::abs(p.t - q.t), glm::length(p.space - q.space));
}

sim::VehicleState after_exact_steps(int steps, double duration, const sim::Drive& d) {
    sim::VehicleState state;
    for (int i = 0; i < steps; ++i) {
        state = sim::exact_step(state, sim::ProperTime(duration / steps), d);
    }
    return state;
}

} // namespace

TEST_CASE("one exact step is the hyperbola, however long or short") {
    for (const double tau : {1e-9, 1e-3, 0.3, 0.999, 1.001, 5.0, 20.0}) {
        const sim::Motion m = sim::exact_motion({}, sim::ProperTime(tau), drive({0.0, 0.0, 1.0}, {}));
        INFO(tau);
        CHECK_THAT(m.displacement.t, WithinRel(std::sinh(tau), 4e-16)); // a rounding or two
        // A few roundings of t: space is read from sums and differences with it.
        CHECK_THAT(m.displacement.space.z,
                   WithinAbs(2.0 * std::pow(std::sinh(0.5 * tau), 2.0), 4e-16 * std::sinh(tau)));
        CHECK_THAT(m.spin_change.a.re, WithinRel(std::expm1(0.5 * tau), 8e-16));
        CHECK_THAT(m.spin_change.d.re, WithinAbs(std::expm1(-0.5 * tau), 8e-16 * std::exp(0.5 * tau)));
        CHECK(m.spin_change.a.im == 0.0);
    }
}

TEST_CASE("one exact step turns a ship at rest on the spot") {
    for (const double angle : {1e-6, 0.5, 1.5, 3.0}) {
        const sim::Motion m = sim::exact_motion({}, sim::ProperTime(2.0), drive({}, {0.0, 0.5 * angle, 0.0}));
        CHECK(m.displacement.space == glm::dvec3(0.0));
        CHECK_THAT(m.displacement.t, WithinRel(2.0, 4e-16));
        const auto turned = sim::rotation<sim::World, sim::Vehicle>(sim::Radians(angle), {0.0, 1.0, 0.0});
        CHECK(apart(sim::SpinMatrix() + m.spin_change, turned.spin) < 4e-16);
    }
}

TEST_CASE("thrust and turn at right angles and equal: the null rotation") {
    // G^2 = 0, so Lambda = 1 + tau G, and u = (1 + tau G)(1 + tau G)^dagger is a polynomial in tau.
    constexpr double tau = 3.0;
    const sim::Motion m = sim::exact_motion({}, sim::ProperTime(tau), drive({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}));
    CHECK(apart(m.spin_change, tau * sim::half_generator(drive({1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}))) < 1e-15);
    // u = (1 + tau^2/2, tau, tau^2/2, 0): a circle whose centre flees at the speed of light.
    CHECK_THAT(m.displacement.t, WithinRel(tau + tau * tau * tau / 6.0, 4e-16));
    CHECK_THAT(m.displacement.space.x, WithinRel(tau * tau / 2.0, 4e-16));
    CHECK_THAT(m.displacement.space.y, WithinRel(tau * tau * tau / 6.0, 4e-16));
    CHECK(m.displacement.space.z == 0.0);
}

TEST_CASE("an exact step is as good as many, and series and functions meet") {
    sim_tests::RandomFrames random;
    for (int i = 0; i < 200; ++i) {
        // |4 q| from 0.2 to 5 in one step, always below 1 in each of eight.
        const sim::Drive d = drive(random.uniform(0.0, 1.5) * random.unit(), random.uniform(0.0, 1.5) * random.unit());
        const sim::VehicleState one = after_exact_steps(1, 1.0, d);
        const sim::VehicleState eight = after_exact_steps(8, 1.0, d);
        // Entries of about e^0.75, each step with its roundings.
        CHECK(apart(one.world_from_vehicle.spin, eight.world_from_vehicle.spin) < 4e-15);
        CHECK(apart(one.event, eight.event) < 6e-15);
    }
}

TEST_CASE("every integrator tends to the exact motion, and RK4 with the fourth power of its step") {
    const sim::Drive d = drive({1.5, -0.5, 0.25}, {0.3, -1.2, 0.9});
    const sim::Event exact = after_exact_steps(64, 2.0, d).event;
    const auto flown = [&d](int steps, const auto& step, auto state) {
        for (int i = 0; i < steps; ++i) {
            state = step(state, sim::ProperTime(2.0 / steps), d);
        }
        return state.event;
    };
    const auto plain = [](const auto& s, sim::ProperTime h, const sim::Drive& by) {
        return sim::rk4_tetrad_step(s, h, by);
    };
    const auto normalised = [](const auto& s, sim::ProperTime h, const sim::Drive& by) {
        return sim::orthonormal(sim::rk4_tetrad_step(s, h, by));
    };
    const auto unprojected = [](const auto& s, sim::ProperTime h, const sim::Drive& by) {
        return sim::rk4_spin_step(s, h, by);
    };
    const auto scaled = [](const auto& s, sim::ProperTime h, const sim::Drive& by) {
        return sim::scaled_to_unit_determinant(sim::rk4_spin_step(s, h, by));
    };
    const auto corrected = [](const auto& s, sim::ProperTime h, const sim::Drive& by) {
        return sim::smallest_corrected(sim::rk4_spin_step(s, h, by));
    };
    const auto flies = [](const auto& s, sim::ProperTime h, const sim::Drive& by) { return sim::step(s, h, by); };
    const auto order = [&](const auto& step, const auto& start) {
        const double coarse = apart(flown(60, step, start), exact);
        const double fine = apart(flown(120, step, start), exact);
        CHECK(fine < 2e-6); // |drive| h = 0.04: (0.04)^4 of an event at 10, and less
        return std::log2(coarse / fine);
    };
    // The fifth order shows by a few per cent.
    CHECK_THAT(order(plain, sim::TetradState()), WithinAbs(4.0, 0.15));
    CHECK_THAT(order(normalised, sim::TetradState()), WithinAbs(4.0, 0.15));
    CHECK_THAT(order(unprojected, sim::SpinState()), WithinAbs(4.0, 0.15));
    CHECK_THAT(order(scaled, sim::SpinState()), WithinAbs(4.0, 0.15));
    CHECK_THAT(order(corrected, sim::SpinState()), WithinAbs(4.0, 0.15));
    CHECK_THAT(order(flies, sim::VehicleState()), WithinAbs(4.0, 0.15));
}

TEST_CASE("the projections restore what they are for") {
    const sim::Drive d = drive({1.5, -0.5, 0.25}, {0.3, -1.2, 0.9});
    sim::TetradState axes;
    sim::SpinState spin;
    for (int i = 0; i < 20; ++i) {
        axes = sim::rk4_tetrad_step(axes, sim::ProperTime(0.1), d);
        spin = sim::rk4_spin_step(spin, sim::ProperTime(0.1), d);
    }
    CHECK(std::abs(sim::dot(axes.axes[0], axes.axes[0]) + 1.0) > 1e-6); // coarse steps drift
    CHECK(std::abs(determinant(spin.spin).re - 1.0) > 1e-8);
    const sim::TetradState sound = sim::orthonormal(axes);
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            const double expected = i != j ? 0.0 : i == 0 ? -1.0 : 1.0;
            CHECK_THAT(sim::dot(sound.axes[i], sound.axes[j]), WithinAbs(expected, 1e-13)); // gamma^2 = 100 roundings
        }
    }
    const auto off = [](const sim::SpinState& s) {
        const sim::Complex det = determinant(s.spin);
        return std::hypot(det.re - 1.0, det.im);
    };
    CHECK(off(sim::scaled_to_unit_determinant(spin)) < 1e-14);
    CHECK(off(sim::smallest_corrected(spin)) < 1e-14); // of first order: (2e-8)^2 and roundings
}

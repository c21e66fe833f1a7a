#include "sim/spacetime/bundle.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/spacetimes.h"
#include "sim/spacetime/world_line.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

namespace {

using sim::Components;
using sim::ObserverKind;
using std::numbers::pi;

template <class Spacetime>
sim::WorldLineState observer(const Spacetime& spacetime, const Components<double>& event, ObserverKind kind) {
    const auto u = sim::observer_velocity(spacetime, event, kind);
    const glm::dvec3 inwards = -sim::space(event) / sim::chart_radius(event);
    return {event, sim::camera_tetrad(spacetime, event, u.value(), inwards, {0.0, 0.0, 1.0})};
}

template <class Spacetime>
sim::WorldLineState flown(const Spacetime& spacetime, sim::WorldLineState state, double proper_time, int steps,
                          const glm::dvec3& thrust = glm::dvec3(0.0), const glm::dvec3& turn = glm::dvec3(0.0)) {
    for (int i = 0; i < steps; ++i) {
        state = sim::advance_observer(spacetime, state, thrust, turn, proper_time / steps);
    }
    return state;
}

} // namespace

TEST_CASE("a gyroscope on a circular orbit turns by de Sitter's angle") {
    const sim::Schwarzschild hole(1.0);
    const double r = 10.0;
    const auto start = observer(hole, {0.0, r, 0.0, 0.0}, ObserverKind::circular_orbit);
    // Kepler's law holds in Schwarzschild's t; u^t = 1/sqrt(1 - 3 M/r).
    const double proper_period = 2.0 * pi * std::pow(r, 1.5) * std::sqrt(1.0 - 3.0 / r);
    const auto end = flown(hole, start, proper_period, 2000);
    CHECK(std::abs(end.event.x - r) < 1e-7);
    CHECK(std::abs(end.event.y) < 1e-7);
    // Back at the same place the tetrad has turned about z by 2 pi (1 - sqrt(1 - 3 M/r)), with the orbit (MTW 40.34).
    const auto g = hole.metric(end.event);
    const double cosine = sim::contract(start.tetrad.legs[3], g * end.tetrad.legs[3]);
    const double sine = sim::contract(start.tetrad.legs[1], g * end.tetrad.legs[3]);
    // legs[3] (back) is radially outwards, legs[1] (right) along +y, the way of the orbit.
    CHECK(std::abs(std::remainder(std::atan2(sine, cosine) - 2.0 * pi * (1.0 - std::sqrt(1.0 - 3.0 / r)), 2.0 * pi)) <
          1e-7); // 2000 steps of 0.08: (0.003 rad)^4 a step
    CHECK(std::abs(sim::contract(end.tetrad.legs[2], g * start.tetrad.legs[2]) - 1.0) < 1e-12);
}

TEST_CASE("a ship that thrusts by M/(r^2 sqrt(1 - 2 M/r)) hovers") {
    const sim::Schwarzschild hole(1.0);
    for (const double r : {2.5, 6.0, 30.0}) {
        const auto start = observer(hole, {0.0, 0.0, r, 0.0}, ObserverKind::at_rest);
        const double thrust = 1.0 / (r * r * std::sqrt(1.0 - 2.0 / r));
        const auto end = flown(hole, start, 5.0, 500, {0.0, 0.0, thrust}); // back is outwards
        // An unstable balance: errors grow as exp(tau/4M) near the hole.
        CHECK(std::abs(sim::chart_radius(end.event) - r) < 1e-9);
        CHECK(std::abs(end.event.t - 5.0 / std::sqrt(1.0 - 2.0 / r)) < 1e-8);
        CHECK(sim::orthonormality_drift(hole, end) < 1e-12);
    }
}

TEST_CASE("rain from infinity reaches the centre in its known time, across the horizon") {
    const sim::Schwarzschild hole(1.0);
    const double r = 8.0;
    // tau = 2/3 (r0^1.5 - r^1.5)/sqrt(2 M) (MTW 31.10).
    const double inside = 0.5;
    const double proper_time = 2.0 / 3.0 * (std::pow(r, 1.5) - std::pow(inside, 1.5)) / std::sqrt(2.0);
    const auto end = flown(hole, observer(hole, {0.0, r, 0.0, 0.0}, ObserverKind::free_fall), proper_time, 4000);
    CHECK(std::abs(end.event.x - inside) < 1e-8);
    // E stays 1, to the position's error times the gradient of the metric, 2 M/r^2 = 8 at the end.
    CHECK(std::abs((hole.metric(end.event) * end.tetrad.legs[0]).t + 1.0) < 1e-8);
}

TEST_CASE("a body's geodesic is the same by the tetrad and by Hamilton's equations") {
    const sim::Kerr hole(1.0, 0.9);
    const Components<double> place{0.0, 7.0, 2.0, 3.0};
    const auto rest = observer(hole, place, ObserverKind::zero_angular_momentum);
    const sim::WorldLineState thrown{place, sim::boosted(rest.tetrad, {0.3, 0.2, 0.1})};
    const auto by_tetrad = flown(hole, thrown, 20.0, 2000);
    sim::GeodesicState<double> body{place, hole.metric(place) * thrown.tetrad.legs[0]};
    for (int i = 0; i < 2000; ++i) {
        body = sim::rk4_step(body, 0.01, [&](const auto& at) { return sim::hamilton_equations(hole, at); });
    }
    for (int mu = 0; mu < 4; ++mu) {
        CHECK(std::abs(body.position[mu] - by_tetrad.event[mu]) < 1e-8);
    }
    CHECK(std::abs(sim::hamiltonian(hole, body) + 0.5) < 1e-9);
    const auto before = hole.conserved(sim::GeodesicState<double>{place, hole.metric(place) * thrown.tetrad.legs[0]});
    const auto after = hole.conserved(body);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(after[i] - before[i]) < 1e-8); // E, L_z and Carter's constant, of a body too
    }
}

TEST_CASE("in flat spacetime a thrusting, turning ship flies as the simulator's does") {
    const sim::Minkowski flat;
    sim::WorldLineState start;
    start.tetrad.legs = {
        Components<double>{1.0, 0.0, 0.0, 0.0}, {0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0}};
    // Constant thrust without a turn: hyperbolic motion.
    const auto straight = flown(flat, start, 2.0, 1000, {0.0, 0.0, -1.0});
    CHECK(std::abs(straight.event.t - std::sinh(2.0)) < 1e-10);
    CHECK(std::abs(straight.event.z - (1.0 - std::cosh(2.0))) < 1e-10);
    // A turn of w about up carries ahead (-z) to the left (-x).
    const auto turned = flown(flat, start, 1.0, 1000, glm::dvec3(0.0), {0.0, 0.5, 0.0});
    CHECK(std::abs(-turned.tetrad.legs[3].x + std::sin(0.5)) < 1e-12);
    CHECK(std::abs(-turned.tetrad.legs[3].z + std::cos(0.5)) < 1e-12);
}

TEST_CASE("a Keplerian observer turns with Kepler's angular velocity, dragged by spin") {
    for (const double a : {-0.9, 0.0, 0.9}) {
        const sim::Kerr hole(1.0, a);
        const double r = 8.0;
        // On the equator x^2 + y^2 = r^2 + a^2.
        const Components<double> event{0.0, std::sqrt(r * r + a * a), 0.0, 0.0};
        const double omega = sim::circular_angular_velocity(hole, event, 1.0);
        CHECK(std::abs(omega - 1.0 / (std::pow(r, 1.5) + a)) < 1e-14); // Bardeen, Press & Teukolsky 1972
        CHECK(sim::observer_velocity(hole, event, ObserverKind::circular_orbit).has_value());
    }
    const sim::Schwarzschild hole(1.0);
    CHECK_FALSE(sim::observer_velocity(hole, {0.0, 2.9, 0.0, 0.0}, ObserverKind::circular_orbit).has_value());
    CHECK_FALSE(sim::observer_velocity(hole, {0.0, 1.9, 0.0, 0.0}, ObserverKind::at_rest).has_value());
    CHECK_FALSE(sim::observer_velocity(hole, {0.0, 9.0, 0.0, 1.0}, ObserverKind::circular_orbit).has_value());
}

TEST_CASE("a bundle magnifies by what neighbouring rays say") {
    const auto check = [](const auto& spacetime, const Components<double>& place, const glm::dvec3& seen) {
        const auto u = sim::observer_velocity(spacetime, place, ObserverKind::free_fall);
        const auto eye = sim::camera_tetrad(spacetime, place, u.value(), {-1.0, 0.1, 0.0}, {0.1, 0.2, 1.0});
        sim::RaySettings settings;
        settings.step = 0.05;
        const auto bundle = sim::trace_bundle(spacetime, place, eye, seen, settings);
        REQUIRE(bundle.ray.outcome == sim::RayOutcome::escaped);
        const double h = 1e-5;
        glm::dmat2 differences(0.0);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto towards = [&](double sign) {
                return sim::trace_ray(spacetime, place, eye, glm::normalize(seen + sign * h * bundle.eye_axes[i]),
                                      settings)
                    .infinity.direction;
            };
            const glm::dvec3 moved = (towards(1.0) - towards(-1.0)) / (2.0 * h);
            differences[static_cast<glm::length_t>(i)] = {glm::dot(moved, bundle.sky_axes[0]),
                                                          glm::dot(moved, bundle.sky_axes[1])};
        }
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < 2; ++k) {
                // Central differences: h^2 times a third derivative of up to 1e3, near the ring.
                CHECK(std::abs(bundle.sky_from_eye[i][k] - differences[i][k]) <
                      1e-6 + 1e-6 * std::abs(differences[i][k]));
            }
        }
    };
    check(sim::Schwarzschild(1.0), {0.0, 10.0, 0.0, 0.0}, glm::normalize(glm::dvec3(0.7, 0.1, -0.7)));
    check(sim::Kerr(1.0, 0.9), {0.0, 8.0, 2.0, 1.0}, glm::normalize(glm::dvec3(-0.8, 0.5, -0.6)));
    check(sim::Alcubierre(0.8, 2.0, 2.0), {}, glm::normalize(glm::dvec3(0.5, 0.5, -0.6)));
    check(sim::PlaneWave{0.2, 0.1, 1.0, 3.0}, {}, glm::normalize(glm::dvec3(0.5, 0.5, -0.6)));
    check(sim::Wormhole{1.0}, {0.0, 3.0, 0.0, 0.0}, glm::normalize(glm::dvec3(0.05, 0.02, -1.0)));
    check(sim::Wormhole{1.0}, {0.0, 3.0, 0.0, 0.0}, glm::normalize(glm::dvec3(0.6, 0.2, -1.0)));
}

TEST_CASE("in flat spacetime a bundle magnifies by aberration alone") {
    const sim::Minkowski flat;
    const auto rest =
        sim::camera_tetrad(flat, {}, Components<double>{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
    const double beta = 0.8;
    const auto eye = sim::boosted(rest, {0.0, 0.0, -beta});
    const auto bundle = sim::trace_bundle(flat, {}, eye, {0.6, 0.0, -0.8}, {});
    // dOmega_eye/dOmega_world = D^2, and D = 1/frequency ratio (PHYSICS 4).
    const double d = 1.0 / bundle.ray.frequency_ratio();
    CHECK(std::abs(bundle.magnification() / (d * d) - 1.0) < 1e-12);
    CHECK_FALSE(bundle.mirrored());
}

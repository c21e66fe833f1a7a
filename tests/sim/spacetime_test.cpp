#include "sim/bad_input.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/sky_rays.h"
#include "sim/spacetime/spacetimes.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>

#include <cstring>
#include <vector>

namespace {

using sim::Components;
using sim::GeodesicState;
using sim::SymmetricTensor;

/// One spacetime of each kind, with places where it is curved, and one so far away that it is not.
struct Case {
    std::string name;
    sim::ParameterValues parameters;
    std::vector<Components<double>> places;
    Components<double> far;
};

std::vector<Case> cases() {
    const std::vector<Components<double>> around_hole{{0.0, 4.0, 1.0, -2.0},
                                                      {1.0, -1.5, 2.0, 0.3},
                                                      {-2.0, 0.1, -0.2, 2.6},
                                                      {0.0, 0.9, 0.8, 0.9},
                                                      {0.0, 0.0, 0.0, 3.0}};
    const Components<double> far{0.0, 3e8, -2e8, 1e8};
    return {
        {"minkowski", {}, {{1.0, 2.0, 3.0, 4.0}}, far},
        {"schwarzschild", {}, around_hole, far},
        {"schwarzschild", {{"mass", 2.5}}, around_hole, far},
        {"kerr", {{"spin", 0.9}}, around_hole, far},
        {"kerr", {{"spin", -0.999}, {"mass", 1.2}}, around_hole, far},
        {"reissner-nordstroem", {{"charge", 0.8}}, around_hole, far},
        {"alcubierre", {{"speed", 0.5}}, {{0.0, 0.0, 0.0, 0.0}, {1.0, 2.2, 0.7, 0.2}, {-1.0, 1.4, 0.1, 0.1}}, far},
        {"alcubierre", {{"speed", 2.5}}, {{0.3, 0.1, 0.0, 0.0}, {1.0, 4.2, 0.7, 0.2}, {-1.0, -0.4, 0.1, 0.1}}, far},
        {"wormhole", {}, {{0.0, 2.0, 0.0, 0.0}, {0.0, 0.3, 0.4, 0.1}, {0.0, 0.1, -0.1, 0.05}}, far},
        {"plane-wave", {{"cross", 0.2}}, {{0.0, 1.0, 2.0, 0.1}, {1.3, 0.0, 0.0, 0.0}, {-1.0, 4.0, 0.0, -3.0}}, far},
    };
}

/// Calls test(spacetime, case) for each.
template <class Test>
void for_each_spacetime(const Test& test) {
    for (const Case& each : cases()) {
        INFO(each.name);
        std::visit([&](const auto& spacetime) { test(spacetime, each); },
                   sim::make_spacetime("test", each.name, each.parameters));
    }
}

/// Signs of the pivots of Gauss's elimination: the metric's signature (Sylvester).
int negative_pivots(SymmetricTensor<double> g) {
    // Space first: its block must be positive by itself for the chart's slices of constant t to be space-like.
    constexpr std::array order{3, 2, 1, 0};
    int negative = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const int p = order[i];
        negative += g(p, p) < 0.0 ? 1 : 0;
        for (std::size_t j = i + 1; j < 4; ++j) {
            for (std::size_t k = j; k < 4; ++k) {
                g(order[j], order[k]) -= g(p, order[j]) * g(p, order[k]) / g(p, p);
            }
        }
    }
    return negative;
}

/// The unit vector between two.
glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 sum = a + b;
    return sum / std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
}

/// An eye in free fall at the first place, looking towards the origin (or +x).
template <class Spacetime>
sim::Tetrad falling_eye(const Spacetime& spacetime, const Components<double>& place) {
    const auto u = sim::observer_velocity(spacetime, place, sim::ObserverKind::free_fall);
    const glm::dvec3 x = sim::space(place);
    const double r = sim::chart_radius(place);
    return sim::camera_tetrad(spacetime, place, *u, r > 0.0 ? -x / r : glm::dvec3(1.0, 0.0, 0.0), {0.1, 0.3, 1.0});
}

} // namespace

TEST_CASE("each spacetime's inverse metric inverts its metric, with signature (-,+,+,+)") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        for (const auto& x : each.places) {
            const auto g = spacetime.metric(x);
            const auto up = spacetime.inverse_metric(x);
            CHECK(negative_pivots(g) == 1);
            for (int mu = 0; mu < 4; ++mu) {
                for (int nu = 0; nu < 4; ++nu) {
                    double sum = 0.0;
                    for (int k = 0; k < 4; ++k) {
                        sum += g(mu, k) * up(k, nu);
                    }
                    // Components reach 20 near the horizons: some 400 roundings of 1.
                    CHECK(std::abs(sum - (mu == nu ? 1.0 : 0.0)) < 1e-13);
                    // The general inverse, which knows nothing of this metric.
                    CHECK(std::abs(sim::inverse(g)(mu, nu) - up(mu, nu)) < 1e-11);
                }
            }
        }
    });
}

TEST_CASE("each spacetime's equations of motion are the derivatives of its Hamiltonian") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        for (const auto& x : each.places) {
            const GeodesicState<double> state{x, {-1.0, 0.4, -0.7, 0.3}};
            const auto by_hand = sim::hamilton_equations(spacetime, state);
            const auto differentiated = sim::differentiated_hamilton_equations(spacetime, state);
            for (int mu = 0; mu < 4; ++mu) {
                const double size = 1.0 + std::abs(differentiated.momentum[mu]);
                // Two orders of the same operations.
                CHECK(std::abs(by_hand.position[mu] - differentiated.position[mu]) < 1e-12 * size);
                CHECK(std::abs(by_hand.momentum[mu] - differentiated.momentum[mu]) < 1e-11 * size);
                // Central differences of fourth order: h^4 f'''''/30 and 1e-16/h, both near 1e-12 of derivatives up to
                // 1e3 near the far side of the wormhole.
                const double h = 1e-3 * std::min(1.0, sim::chart_radius(x) + 0.05);
                const auto at = [&](double step) {
                    GeodesicState<double> moved = state;
                    moved.position[mu] += step;
                    return sim::hamiltonian(spacetime, moved);
                };
                const double slope = (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h);
                CHECK(std::abs(by_hand.momentum[mu] + slope) < 1e-7 * size);
            }
        }
    });
}

TEST_CASE("each spacetime is flat at infinity") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        const auto g = spacetime.metric(each.far);
        for (int mu = 0; mu < 4; ++mu) {
            for (int nu = mu; nu < 4; ++nu) {
                const double flat = mu != nu ? 0.0 : mu == 0 ? -1.0 : 1.0;
                CHECK(std::abs(g(mu, nu) - flat) < 1e-7); // 2 M/r at 3.7e8 M, M up to 2.5
            }
        }
    });
}

TEST_CASE("rays keep their constants, better by 16 for half the step") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        const auto& place = each.places.front();
        const sim::Tetrad eye = falling_eye(spacetime, place);
        std::array<double, 2> worst{};
        for (const auto& seen : sim_tests::random_directions(7, 60)) {
            for (std::size_t i = 0; i < 2; ++i) {
                sim::RaySettings settings;
                settings.step = i == 0 ? 0.06 : 0.03;
                const auto ray = sim::trace_ray(spacetime, place, eye, seen, settings);
                CHECK((ray.outcome == sim::RayOutcome::escaped || ray.outcome == sim::RayOutcome::captured));
                if (ray.outcome == sim::RayOutcome::escaped) {
                    worst[i] = std::max({worst[i], ray.hamiltonian_drift, *std::ranges::max_element(ray.drifts)});
                }
            }
        }
        CHECK(worst[0] < 2e-3);
        // 16 in the limit; 10 leaves room for steps that are not small yet, 1e-12 for what is exact.
        CHECK((worst[1] < worst[0] / 10.0 || worst[0] < 1e-12));
    });
}

TEST_CASE("a tetrad is orthonormal wherever an observer can be") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        for (const auto& place : each.places) {
            const auto g = spacetime.metric(place);
            for (const auto& tetrad :
                 {falling_eye(spacetime, place), sim::boosted(falling_eye(spacetime, place), {0.3, -0.6, 0.5})}) {
                for (std::size_t a = 0; a < 4; ++a) {
                    for (std::size_t b = 0; b < 4; ++b) {
                        const double expected = a != b ? 0.0 : a == 0 ? -1.0 : 1.0;
                        // Legs with components up to 50 where the wormhole's chart is stretched.
                        CHECK(std::abs(sim::contract(tetrad.legs[a], g * tetrad.legs[b]) - expected) < 1e-12);
                    }
                }
            }
        }
    });
}

TEST_CASE("rays on lanes are the same bits as rays one by one") {
    for_each_spacetime([](const auto& spacetime, const Case& each) {
        const auto& place = each.places.front();
        const sim::Tetrad eye = falling_eye(spacetime, place);
        const auto seen = sim_tests::random_directions(7, 101);
        std::vector<sim::SkyRay> rays(seen.size());
        sim::RaySettings settings;
        settings.step = 0.1;
        sim::trace_sky(spacetime, place, eye, seen, settings, rays);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const auto one = sim::trace_ray(spacetime, place, eye, seen[i], settings);
            CHECK(one.outcome == rays[i].outcome);
            CHECK(one.steps == rays[i].steps);
            CHECK(std::memcmp(&one.infinity.direction, &rays[i].infinity.direction, sizeof(glm::dvec3)) == 0);
            CHECK(one.hamiltonian_drift == rays[i].hamiltonian_drift);
        }
    });
}

TEST_CASE("the time-reversed chart of a hole shows the same light") {
    int compared = 0;
    for_each_spacetime([&](const auto& spacetime, const Case& each) {
        if constexpr (sim::TimeReversible<std::remove_cvref_t<decltype(spacetime)>>) {
            for (const Components<double>& place : each.places) {
                const sim::Tetrad eye = falling_eye(spacetime, place);
                for (const glm::dvec3& any : sim_tests::random_directions(7, 12)) {
                    // More or less towards the hole.
                    const glm::dvec3 seen = between(any, {0.0, 0.0, -1.0});
                    const GeodesicState<double> photon = sim::seen_photon(spacetime, place, eye, seen);
                    if (!spacetime.reversible(place)) {
                        CHECK_FALSE(sim::starts_reversed(spacetime, photon));
                        continue;
                    }
                    // Its own inverse, and an isometry but for the sense of time. Rounding grows as M/(r - r_+), below
                    // 100 at these places.
                    const GeodesicState<double> there = spacetime.time_reversed(photon);
                    const GeodesicState<double> back = spacetime.time_reversed(there);
                    CHECK(std::abs(spacetime.remoteness(there.position) - spacetime.remoteness(place)) < 1e-13);
                    CHECK(there.momentum.t == -photon.momentum.t);
                    const double size = std::sqrt(sim::momentum2(photon) + sim::momentum2(there));
                    CHECK(std::abs(sim::hamiltonian(spacetime, there)) < 1e-12 * size * size);
                    for (int mu = 0; mu < 4; ++mu) {
                        CHECK(std::abs(back.position[mu] - place[mu]) < 1e-12);
                        CHECK(std::abs(back.momentum[mu] - photon.momentum[mu]) < 1e-12 * size);
                    }
                    // A visitor keeps the ray in the spacetime's own chart. Errors at this step are some 1e-8.
                    sim::RaySettings settings;
                    settings.step = 0.01;
                    const auto one = sim::follow_ray(spacetime, photon, settings);
                    const auto other = sim::follow_ray(spacetime, photon, settings,
                                                       [](const sim::RaySegment& /*s*/) { return sim::Visit::go_on; });
                    CHECK(one.outcome == other.outcome);
                    if (one.outcome == sim::RayOutcome::escaped && one.reversed_steps > 0) {
                        ++compared;
                        CHECK(other.reversed_steps == 0);
                        CHECK(sim::angle_between(one.infinity.direction, other.infinity.direction) < 1e-6);
                    }
                }
            }
        }
    });
    CHECK(compared > 15);
}

TEST_CASE("the estimated error of a ray bounds its true error") {
    const sim::Schwarzschild hole(1.0);
    const Components<double> place{0.0, 10.0, 0.0, 0.0};
    const auto u = sim::observer_velocity(hole, place, sim::ObserverKind::at_rest);
    const sim::Tetrad eye = sim::camera_tetrad(hole, place, *u, {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    // reference/schwarzschild_static_observer.csv, r = 10: angle from the inward radial direction, angle swept.
    for (const auto& [psi, swept] :
         {std::pair{0.6, 3.93313517446859391}, {1.0, 2.66000410131596271}, {2.0, 1.2969414231071171}}) {
        for (const double step : {0.1, 0.05, 0.0125}) {
            sim::RaySettings settings;
            settings.step = step;
            const auto ray =
                sim::trace_ray_with_error(hole, place, eye, {std::sin(psi), 0.0, -std::cos(psi)}, settings);
            const double error = sim::angle_between(ray.infinity.direction, {std::cos(swept), std::sin(swept), 0.0});
            CHECK(ray.outcome == sim::RayOutcome::escaped);
            CHECK(error < ray.error);
            CHECK(ray.error < 30.0 * error);
            CHECK(std::abs(ray.frequency_ratio() - 1.11803398874989485) <
                  1e-14); // 1/sqrt(1 - 2/10), exact but rounding
        }
    }
}

TEST_CASE("a visitor sees the whole path and can stop it") {
    const sim::Schwarzschild hole(1.0);
    const Components<double> place{0.0, 10.0, 0.0, 0.0};
    const sim::Tetrad eye = falling_eye(hole, place);
    Components<double> last = place;
    const auto ray = sim::trace_ray(hole, place, eye, {0.8, 0.0, -0.6}, {}, [&](const sim::RaySegment& segment) {
        CHECK(segment.from.position.x == last.x);
        // The Hermite curve and a half step of the same integrator agree to the order of both: (step r)^4 times the
        // fourth derivative, which far out is the path's parameter running ahead.
        const auto half = sim::geodesic_step(hole, segment.from, -0.5 * segment.length);
        CHECK(sim::chart_radius(segment.at(0.5) - half.position) < 3e-5 * sim::chart_radius(half.position));
        CHECK(segment.to.position.t < segment.from.position.t);
        last = segment.to.position;
        return sim::chart_radius(last) > 30.0 ? sim::Visit::stop : sim::Visit::go_on;
    });
    CHECK(ray.outcome == sim::RayOutcome::hit_object);
    CHECK(sim::chart_radius(ray.end.position) > 30.0);
}

TEST_CASE("spacetimes that cannot be are refused by name") {
    CHECK_THROWS_AS(sim::make_spacetime("file", "kerr", {{"spin", 1.1}}), sim::BadInput);
    CHECK_THROWS_AS(sim::make_spacetime("file", "schwarzschild", {{"mass", -1.0}}), sim::BadInput);
    CHECK_THROWS_AS(sim::make_spacetime("file", "schwarzschild", {{"mass", std::nan("")}}), sim::BadInput);
    CHECK_THROWS_AS(sim::make_spacetime("file", "schwarzschild", {{"spin", 0.5}}), sim::BadInput);
    CHECK_THROWS_AS(sim::make_spacetime("file", "ker", {}), sim::BadInput);
    CHECK_THROWS_AS(sim::make_spacetime("file", "alcubierre", {{"sigma", 1e4}}), sim::BadInput);
}

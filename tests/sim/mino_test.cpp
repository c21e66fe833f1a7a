#include "sim/spacetime/exponential.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"
#include "sim/spacetime/sine_cosine.h"
#include "tests/sim/random_frames.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cstring>
#include <numbers>
#include <vector>

namespace {

using sim::Components;

struct Case {
    std::string name;
    sim::ParameterValues parameters;
    Components<double> place;
};

/// Holes and eyes: near and far, on the axis, in the ergoregion's neighbourhood, with either spin.
const std::vector<Case> cases{
    {"schwarzschild", {}, {0.0, 6.0, 1.0, 2.0}},
    {"schwarzschild", {{"mass", 0.3}}, {0.0, 2.0, 1.0, -1.0}},
    {"kerr", {{"spin", 0.9}}, {0.0, 5.0, 3.0, 2.0}},
    {"kerr", {{"spin", 0.999}}, {0.0, 0.0, 0.0, 7.0}},
    {"kerr", {{"spin", 0.95}}, {0.0, 1.2, -1.8, 0.4}},
    {"kerr", {{"spin", -0.99}, {"mass", 1.5}}, {0.0, 9.0, 3.0, -4.0}},
    {"reissner-nordstroem", {{"charge", 0.9}}, {0.0, 5.0, 3.0, 1.0}},
};

sim::Tetrad falling_eye(const sim::AnySpacetime& spacetime, const Components<double>& place) {
    return std::visit(
        [&](const auto& chosen) {
            const auto u = sim::observer_velocity(chosen, place, sim::ObserverKind::free_fall);
            return sim::camera_tetrad(chosen, place, *u, -sim::space(place), {0.2, 0.3, 0.8});
        },
        spacetime);
}

std::vector<sim::SkyRay> traced(const Case& each, sim::RayKernel kernel, double step,
                                const std::vector<glm::dvec3>& seen) {
    const auto hole = sim::make_spacetime("test", each.name, each.parameters);
    sim::RaySettings settings;
    settings.step = step;
    std::vector<sim::SkyRay> rays(seen.size());
    sim::SkyTracer(hole, each.place, falling_eye(hole, each.place), settings, kernel).trace(seen, rays);
    return rays;
}

} // namespace

TEST_CASE("light in Mino time comes from where the generic kernel says") {
    const auto seen = sim_tests::random_directions(11, 300);
    for (const Case& each : cases) {
        INFO(each.name << " from " << each.place.x << " " << each.place.y << " " << each.place.z);
        const auto generic = traced(each, sim::RayKernel::generic, 0.01, seen);
        const auto mino = traced(each, sim::RayKernel::mino, 0.01, seen);
        std::vector<double> angles;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            REQUIRE(generic[i].outcome == mino[i].outcome);
            if (mino[i].outcome == sim::RayOutcome::escaped) {
                angles.push_back(sim::angle_between(generic[i].infinity.direction, mino[i].infinity.direction));
                // Both are -p_t of the same photon.
                CHECK(std::abs(generic[i].infinity.frequency / mino[i].infinity.frequency - 1.0) < 1e-12);
            }
        }
        std::ranges::sort(angles);
        // The generic kernel's error at this step is 1e-9; near the orbit of light it is stretched, by 1e3 in the worst
        // of 300 rays.
        CHECK(angles[angles.size() / 2] < 3e-9);
        CHECK(angles.back() < 3e-6);
    }
}

TEST_CASE("the Nystroem form is of fourth order") {
    const auto seen = sim_tests::random_directions(11, 100);
    for (const Case& each : cases) {
        INFO(each.name);
        const auto finest = traced(each, sim::RayKernel::mino, 0.00625, seen);
        std::array<double, 2> median{};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto rays = traced(each, sim::RayKernel::mino, i == 0 ? 0.1 : 0.05, seen);
            std::vector<double> angles;
            for (std::size_t k = 0; k < seen.size(); ++k) {
                if (rays[k].outcome == sim::RayOutcome::escaped) {
                    angles.push_back(sim::angle_between(rays[k].infinity.direction, finest[k].infinity.direction));
                }
            }
            std::ranges::sort(angles);
            median[i] = angles[angles.size() / 2];
        }
        // 2^4 in the limit of small steps.
        CHECK(median[0] / median[1] > 14.0);
        CHECK(median[0] / median[1] < 19.0);
    }
}

TEST_CASE("in Mino time too, lanes give the same bits as one ray at a time") {
    const auto seen = sim_tests::random_directions(11, 61);
    for (const Case& each : cases) {
        const auto hole = sim::make_spacetime("test", each.name, each.parameters);
        const auto eye = sim::mino_eye(hole, *sim::mino_hole(hole), each.place, falling_eye(hole, each.place));
        sim::RaySettings settings;
        settings.step = 0.2;
        std::vector<sim::SkyRay> lanes(seen.size()), single(seen.size());
        std::vector<sim::PlaneCrossings> lane_crossings(seen.size()), single_crossings(seen.size());
        sim::trace_mino_sky(eye, seen, settings, lanes, lane_crossings);
        sim::trace_mino_sky_one_by_one(eye, seen, settings, single, single_crossings);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            CHECK(lanes[i].outcome == single[i].outcome);
            CHECK(std::memcmp(&lanes[i].infinity.direction, &single[i].infinity.direction, sizeof(glm::dvec3)) == 0);
            REQUIRE(lane_crossings[i].count == single_crossings[i].count);
            for (std::size_t k = 0; k < static_cast<std::size_t>(lane_crossings[i].count); ++k) {
                CHECK(lane_crossings[i].crossing[k].radius == single_crossings[i].crossing[k].radius);
                CHECK(lane_crossings[i].crossing[k].azimuth == single_crossings[i].crossing[k].azimuth);
            }
        }
    }
}

TEST_CASE("single precision is good to 1e-5 rad away from the orbit of light") {
    const auto seen = sim_tests::random_directions(11, 400);
    for (const Case& each : cases) {
        INFO(each.name);
        const auto hole = sim::make_spacetime("test", each.name, each.parameters);
        const auto tetrad = falling_eye(hole, each.place);
        sim::RaySettings settings;
        settings.step = 0.05;
        std::vector<sim::SkyRay> precise(seen.size()), fast(seen.size());
        sim::SkyTracer(hole, each.place, tetrad, settings).trace(seen, precise);
        sim::SkyTracer(hole, each.place, tetrad, settings, sim::RayKernel::automatic, sim::Precision::single_precision)
            .trace(seen, fast);
        std::vector<double> angles;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            if (precise[i].outcome == sim::RayOutcome::escaped && fast[i].outcome == sim::RayOutcome::escaped) {
                angles.push_back(sim::angle_between(precise[i].infinity.direction, fast[i].infinity.direction));
            }
        }
        std::ranges::sort(angles);
        // Some 100 roundings of 6e-8 each, stretched by bending: 1e-5 for 95 in 100.
        CHECK(angles[angles.size() * 95 / 100] < 1e-5);
    }
}

TEST_CASE("crossings of the equatorial plane are where the generic kernel's path crosses it") {
    const sim::Kerr kerr(1.0, 0.9);
    const Components<double> place{0.0, 12.0, 2.0, 5.0};
    const auto tetrad = falling_eye(kerr, place);
    const auto eye = sim::mino_eye(kerr, *sim::mino_hole(kerr), place, tetrad);
    sim::RaySettings settings;
    settings.step = 0.05;
    // Towards the hole, where most rays cross once or twice.
    std::vector<glm::dvec3> seen = sim_tests::random_directions(11, 200);
    for (auto& n : seen) {
        n = glm::dvec3(0.3 * n.x, 0.3 * n.y, -1.0);
        n /= std::sqrt(n.x * n.x + n.y * n.y + 1.0);
    }
    std::vector<sim::SkyRay> rays(seen.size());
    std::vector<sim::PlaneCrossings> crossings(seen.size());
    sim::trace_mino_sky(eye, seen, settings, rays, crossings);
    int compared = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        std::vector<Components<double>> expected;
        sim::RaySettings fine;
        fine.step = 0.02;
        sim::trace_ray(kerr, place, tetrad, seen[i], fine, [&](const sim::RaySegment& segment) {
            if (segment.from.position.z * segment.to.position.z < 0.0) {
                double low = 0.0, high = 1.0;
                for (int k = 0; k < 50; ++k) {
                    const double middle = 0.5 * (low + high);
                    (segment.at(middle).z * segment.from.position.z > 0.0 ? low : high) = middle;
                }
                expected.push_back(segment.at(low));
            }
            return sim::Visit::go_on;
        });
        for (std::size_t k = 0; k < static_cast<std::size_t>(crossings[i].count) && k < expected.size(); ++k) {
            const double r = kerr.radius(expected[k]);
            if (r < 2.0 || r > 40.0) {
                continue; // the dragging diverges at the horizon; far out azimuths tell nothing of it
            }
            // Kerr-Schild's x + i y = (r + i a) exp(i phi + i a/(r_+ - r_-) ln((r - r_+)/(r - r_-))).
            const double rp = kerr.radii.horizon, rm = 2.0 - rp;
            const double phi = std::atan2(expected[k].y, expected[k].x) - std::atan2(0.9, r) -
                               0.9 / (rp - rm) * std::log((r - rp) / (r - rm));
            // Cubic Hermite curves over steps of 0.05 rad: (0.05)^4/384 of the path's curvature times r, stretched.
            CHECK(std::abs(crossings[i].crossing[k].radius / r - 1.0) < 2e-5);
            CHECK(std::abs(std::remainder(crossings[i].crossing[k].azimuth - phi, 2.0 * std::numbers::pi)) < 2e-5);
            ++compared;
        }
        const auto photon = sim::seen_photon(kerr, place, tetrad, seen[i]);
        CHECK(std::abs(crossings[i].frequency + photon.momentum.t) < 1e-14);
        CHECK(std::abs(crossings[i].angular_momentum - kerr.conserved(photon)[1]) < 1e-12);
    }
    CHECK(compared > 100);
}

TEST_CASE("the exponential without a library is good to four roundings, on lanes to the same bits") {
    for (double x = -700.0; x <= 700.0; x += 0.37) {
        const double wanted = std::exp(x);
        const double found = sim::exponential(x);
        CHECK(std::abs(found - wanted) <= 4.5e-16 * 2.0 * wanted); // two roundings of 2^-52, and the library's own
        CHECK(sim::exponential(sim::Lanes<double, 8>(x)).v[5] == found);
    }
    CHECK(sim::exponential(0.0) == 1.0);
    const auto d = sim::exponential(sim::Dual<double, 1>::variable(1.5, 0));
    CHECK(d.slope[0] == d.value);
}

TEST_CASE("sine and cosine without a library are good to two roundings") {
    for (double angle = -900.0; angle < 900.0; angle += 0.37) {
        const auto both = sim::sine_cosine(angle);
        CHECK(std::abs(both.sine - std::sin(angle)) < 3e-16);
        CHECK(std::abs(both.cosine - std::cos(angle)) < 3e-16);
    }
    // Single precision's own rounding is 6e-8.
    const auto lanes = sim::sine_cosine(sim::Lanes<float, 4>(-2.5));
    CHECK(std::abs(static_cast<double>(lanes.sine.v[1]) - std::sin(-2.5)) < 2e-7);
    CHECK(std::abs(static_cast<double>(lanes.cosine.v[3]) - std::cos(-2.5)) < 2e-7);
}

TEST_CASE("a step is chosen for an error, for a sky and for each ray") {
    const Case& each = cases[2];
    const auto hole = sim::make_spacetime("test", each.name, each.parameters);
    const auto tetrad = falling_eye(hole, each.place);
    const auto seen = sim_tests::random_directions(11, 300);
    const auto truth = traced(each, sim::RayKernel::mino, 0.005, seen);
    for (const auto kernel : {sim::RayKernel::mino, sim::RayKernel::generic}) {
        for (const double error : {1e-4, 1e-7}) {
            sim::RaySettings settings;
            settings.step = sim::standard_step(kernel);
            sim::SkyTracer tracer(hole, each.place, tetrad, settings, kernel);
            std::vector<sim::SkyRay> rays(seen.size());
            std::vector<double> errors(seen.size());
            CHECK(tracer.trace_to_error(seen, error, rays, errors) == 0);
            for (std::size_t i = 0; i < seen.size(); ++i) {
                CHECK(errors[i] <= error);
                if (truth[i].outcome == sim::RayOutcome::escaped) {
                    // The estimate is twice what the law of the fourth order gives: enough for all but rays whose steps
                    // are still too long for that law.
                    CHECK(sim::angle_between(rays[i].infinity.direction, truth[i].infinity.direction) < 3.0 * error);
                }
            }
            tracer.choose_step(seen, error);
            tracer.trace(seen, rays);
            std::size_t within = 0, escaped = 0;
            for (std::size_t i = 0; i < seen.size(); ++i) {
                if (truth[i].outcome == sim::RayOutcome::escaped) {
                    ++escaped;
                    within +=
                        rays[i].outcome == sim::RayOutcome::escaped &&
                                sim::angle_between(rays[i].infinity.direction, truth[i].infinity.direction) < error
                            ? 1
                            : 0;
                }
            }
            CHECK(static_cast<double>(within) > 0.985 * static_cast<double>(escaped)); // asked for: 0.99
        }
    }
}

TEST_CASE("Mino time refuses an eye that it cannot serve") {
    const auto hole = sim::make_spacetime("test", "kerr", {});
    CHECK_FALSE(sim::fits_mino(*sim::mino_hole(hole), {0.0, 1.2, 0.0, 0.3}));
    CHECK_FALSE(sim::mino_hole(sim::Wormhole{1.0}).has_value());
    // Without spin there is nothing to wind up at the horizon: an eye within sees what the generic kernel says.
    const Case within{"schwarzschild", {}, {0.0, 1.1, 0.3, 0.2}};
    const auto seen = sim_tests::random_directions(11, 200);
    const auto generic = traced(within, sim::RayKernel::generic, 0.02, seen);
    const auto mino = traced(within, sim::RayKernel::mino, 0.02, seen);
    std::size_t escaped = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        CHECK(generic[i].outcome == mino[i].outcome);
        if (mino[i].outcome == sim::RayOutcome::escaped) {
            ++escaped;
            // As above, for steps of 0.02.
            CHECK(sim::angle_between(generic[i].infinity.direction, mino[i].infinity.direction) < 1e-5);
        }
    }
    CHECK(escaped > 20);
}

#include "engine/commands/bench.h"

#include "engine/median.h"
#include "sim/spacetime/clones.h"
#include "sim/spacetime/equatorial_light.h"
#include "sim/spacetime/measured_ray.h"
#include "sim/spacetime/observer.h"

#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <optional>
#include <vector>

namespace engine {
namespace {

using sim::Components;

constexpr double eye_radius = 100.0; // M; the peers' rays run from there to there
constexpr std::size_t rays_at_once = 512;
constexpr double seconds_each = 0.02;
constexpr double fine_step = 0.002;

/// Processor time of this thread, s: what others do on the machine does not count.
double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One way to trace, from directions to rays.
struct Method {
    std::string name;
    double longest_step;
    double least_error; ///< below which it is not asked
    std::function<void(const sim::RaySettings&, std::span<const glm::dvec3>, std::span<sim::SkyRay>)> trace;
};

/// A hole, and an eye at rest in its equatorial plane.
struct Scene {
    std::string name;
    sim::AnySpacetime spacetime;
    double spin;     ///< M = 1
    double critical; ///< impact parameter of the (prograde) circular orbit of light
    Components<double> event{0.0, eye_radius, 0.0, 0.0};
    sim::Tetrad eye{};
};

Scene scene_of(const std::string& name, sim::AnySpacetime spacetime, double spin, double critical) {
    Scene scene{name, std::move(spacetime), spin, critical};
    scene.eye = std::visit(
        [&](const auto& chosen) {
            const auto u = sim::observer_velocity(chosen, scene.event, sim::ObserverKind::zero_angular_momentum);
            return sim::camera_tetrad(chosen, scene.event, u.value(), {-1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
        },
        scene.spacetime);
    return scene;
}

/// b of the circular orbit of light at r: L_z/E (Bardeen, Press & Teukolsky 1972).
double critical_impact(double spin, double r) {
    return spin == 0.0 ? std::sqrt(27.0) : -(r * r * r - 3.0 * r * r + spin * spin * (r + 1.0)) / (spin * (r - 1.0));
}

/// Where light seen from `seen` comes from, by elliptic integrals: followed into the past, prograde light turns back.
glm::dvec3 true_direction(const Scene& scene, const glm::dvec3& seen) {
    const double a = scene.spin;
    const sim::GeodesicState<double> photon = std::visit(
        [&](const auto& chosen) { return sim::seen_photon(chosen, scene.event, scene.eye, seen); }, scene.spacetime);
    const double impact = scene.event.x * photon.momentum.y / -photon.momentum.t;
    const double r = std::sqrt(scene.event.x * scene.event.x - a * a);
    // Boyer-Lindquist's phi of the eye, whose x + i y is real (sim/spacetime/kerr.h).
    const double root = std::sqrt(1.0 - a * a);
    const double azimuth = -std::atan2(a, r) - 0.5 * a / root * std::log((r - 1.0 - root) / (r - 1.0 + root));
    const double phi = azimuth - sim::equatorial_sweep(a, impact, r);
    return {std::cos(phi), std::sin(phi), 0.0};
}

std::vector<Method> methods_of(const Scene& scene) {
    const auto mino = sim::mino_eye(scene.spacetime, *sim::mino_hole(scene.spacetime), scene.event, scene.eye);
    const auto generic_lanes = [&scene](const sim::RaySettings& settings, auto seen, auto rays) {
        sim::trace_sky(scene.spacetime, scene.event, scene.eye, seen, settings, rays);
    };
    const auto generic_scalar = [&scene](const sim::RaySettings& settings, auto seen, auto rays) {
        std::visit(
            [&](const auto& chosen) {
                for (std::size_t i = 0; i < seen.size(); ++i) {
                    const auto ray = sim::trace_ray(chosen, scene.event, scene.eye, seen[i], settings);
                    rays[i] = {ray.infinity, ray.outcome, ray.steps, ray.hamiltonian_drift};
                }
            },
            scene.spacetime);
    };
    return {{"generic, one by one", 0.9, 1e-12, generic_scalar},
            {"generic, lanes of 8 doubles", 0.9, 1e-12, generic_lanes},
            {"Mino, one by one", 0.6, 1e-12,
             [mino](const sim::RaySettings& settings, auto seen, auto rays) {
                 sim::trace_mino_sky_one_by_one(mino, seen, settings, rays);
             }},
            {"Mino, lanes of 8 doubles", 0.6, 1e-12,
             [mino](const sim::RaySettings& settings, auto seen, auto rays) {
                 sim::trace_mino_sky(mino, seen, settings, rays);
             }},
            {"Mino, lanes of 16 floats", 0.6, 1e-5, [mino](const sim::RaySettings& settings, auto seen, auto rays) {
                 sim::trace_mino_sky(mino, seen, settings, rays, {}, sim::Precision::single_precision);
             }}};
}

/// The longest step, in factors of 2^(1/8), whose ray and all finer ones tried are within the error of the truth.
std::optional<double> step_for(const Method& method, const glm::dvec3& seen, const glm::dvec3& truth, double error,
                               std::uint32_t& steps) {
    sim::RaySettings settings;
    settings.tail_error = 0.1 * error;
    const double factor = std::sqrt(std::sqrt(std::sqrt(0.5)));
    int met = 0;
    double chosen = 0.0;
    for (settings.step = method.longest_step; settings.step > 2e-5; settings.step *= factor) {
        sim::SkyRay ray;
        method.trace(settings, {&seen, 1}, {&ray, 1});
        const bool within =
            ray.outcome == sim::RayOutcome::escaped && sim::angle_between(ray.infinity.direction, truth) <= error;
        if (!within) {
            met = 0;
            continue;
        }
        if (met++ == 0) {
            chosen = settings.step;
            steps = ray.steps;
        }
        if (met == 6) { // not by luck: an error may pass through zero
            return chosen;
        }
    }
    return std::nullopt;
}

double rays_per_second(const Method& method, const sim::RaySettings& settings, const glm::dvec3& seen) {
    const std::vector<glm::dvec3> directions(rays_at_once, seen);
    std::vector<sim::SkyRay> rays(rays_at_once);
    std::vector<double> rates;
    const double begin = processor_seconds();
    double now = begin;
    while (now - begin < seconds_each) {
        method.trace(settings, directions, rays);
        const double then = processor_seconds();
        rates.push_back(static_cast<double>(rays_at_once) / (then - now));
        now = then;
    }
    return median(rates);
}

void bench_scene(const Scene& scene) {
    const std::vector<Method> methods = methods_of(scene);
    for (const double share : {1.01, 1.1, 2.0, 10.0}) {
        const double sine = -share * scene.critical / eye_radius; // prograde light is seen on the left
        const glm::dvec3 seen(sine, 0.0, -std::sqrt(1.0 - sine * sine));
        sim::RaySettings fine;
        fine.step = fine_step;
        sim::SkyRay finest;
        methods[2].trace(fine, {&seen, 1}, {&finest, 1});
        const glm::dvec3 truth = true_direction(scene, seen);
        fmt::print(
            "\n{}, {:g} b_c: rays per second of one core (steps), by the error met, rad; Mino time at a step of {:g} "
            "is within {:.1e} of the truth\n{:<28}",
            scene.name, share, fine_step, sim::angle_between(finest.infinity.direction, truth), "");
        for (int digits = 3; digits <= 12; ++digits) {
            fmt::print(" {:>16}", fmt::format("1e-{}", digits));
        }
        for (const Method& method : methods) {
            fmt::print("\n{:<28}", method.name);
            for (int digits = 3; digits <= 12; ++digits) {
                const double error = std::pow(10.0, -digits);
                std::uint32_t steps = 0;
                const auto step =
                    error < 0.99 * method.least_error ? std::nullopt : step_for(method, seen, truth, error, steps);
                if (!step) {
                    fmt::print(" {:>16}", "-");
                    continue;
                }
                sim::RaySettings settings;
                settings.step = *step;
                settings.tail_error = 0.1 * error;
                fmt::print(" {:>16}", fmt::format("{:.3g} ({})", rays_per_second(method, settings, seen), steps));
            }
        }
        fmt::print("\n");
    }
}

void bench_geodesics() {
    fmt::print(
        "light from {:g} M to periapsis and out; vector registers of {} bits; processor time, median of repeats\n"
        "truth: elliptic integrals by quadrature, good to 1e-13, which share nothing with the kernels\n",
        eye_radius, sim::register_width());
    bench_scene(scene_of("Schwarzschild", sim::Schwarzschild(1.0), 0.0, critical_impact(0.0, 3.0)));
    const sim::Kerr kerr(1.0, 0.9);
    bench_scene(scene_of("Kerr a = 0.9", kerr, kerr.spin, critical_impact(0.9, kerr.radii.photon_orbit)));
    fmt::print("\npeers, measured elsewhere on one core of the same kind, one ray at a time:\n"
               "  Motion4D, rk8pd 1e-8, Schwarzschild: 30,400/s at 7.9e-7 rad (1.01 b_c), 40,400/s at 2.8e-9 (2 b_c)\n"
               "  Motion4D, RK4 step 0.1, Schwarzschild: 2,630/s at 2.3e-7 (1.01 b_c), 2,660/s at 9.8e-11 (2 b_c)\n"
               "  Motion4D, rk8pd 1e-8, Kerr a = 0.9: 19,200/s at 3.8e-6 (1.01 b_c)\n"
               "  gyoto 1.4.4, Kerr a = 0.9 disk picture: 369/s by default, 1,883/s tuned, 1e-4 to 1e-7\n"
               "  Blacklight, Kerr a = 0.9, RK4 step 0.1: 8,130/s, error not measured\n");
}

} // namespace

void add_bench_geodesics(CLI::App& bench) {
    bench.add_subcommand("geodesics", "rays of light per second against their error, kernel by kernel")
        ->callback(bench_geodesics);
}

} // namespace engine

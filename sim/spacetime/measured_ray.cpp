#include "sim/spacetime/measured_ray.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace sim {
namespace {

constexpr int most_halvings = 14;

/// The generic kernel, halving the step until the error is met.
template <class Spacetime>
MeasuredRay measure_generic(const Spacetime& spacetime, const GeodesicState<double>& photon, double error,
                            RaySettings settings) {
    MeasuredRay measured;
    settings.step = standard_step(RayKernel::generic);
    RayResult whole = follow_ray(spacetime, photon, settings);
    for (int halving = 0; halving < most_halvings; ++halving) {
        settings.step *= 0.5;
        RayResult halved = follow_ray(spacetime, photon, settings);
        const auto brief = [](const RayResult& ray) { return SkyRay{ray.infinity, ray.outcome, ray.steps, 0.0}; };
        halved.error = estimated_error(brief(whole), brief(halved));
        // Rounding grows with the steps: further halvings only make it worse.
        if (halved.outcome == RayOutcome::step_limit || (whole.error < 1e-9 && halved.error > 0.5 * whole.error)) {
            break;
        }
        whole = halved;
        if (halved.error <= error) {
            break;
        }
    }
    measured.ray = whole;
    return measured;
}

} // namespace

void SweptAngle::turn(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 normal = glm::cross(a, b);
    const double sine = glm::length(normal);
    angle_ += std::copysign(std::atan2(sine, glm::dot(a, b)), glm::dot(normal, axis_));
}

MeasuredRay measure_ray(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                        const glm::dvec3& seen, double error, const RaySettings& settings, RayKernel kernel) {
    const SkyTracer tracer(spacetime, event, tetrad, settings, kernel);
    return std::visit(
        [&](const auto& chosen) {
            const GeodesicState<double> photon = seen_photon(chosen, event, tetrad, seen);
            // Into the past the photon moves along -p^i.
            const glm::dvec3 motion = -space(hamilton_equations(chosen, photon).position);
            const glm::dvec3 axis = glm::cross(space(event), motion);
            SweptAngle swept(glm::length(axis) > 0.0 ? axis : glm::dvec3(0.0, 0.0, 1.0));
            RaySettings coarse = settings;
            coarse.step = 0.2 * standard_step(RayKernel::generic);
            MeasuredRay measured;
            if (tracer.kernel() == RayKernel::mino) {
                RaySettings fine = settings;
                fine.step = standard_step(RayKernel::mino);
                const SkyTracer precise(spacetime, event, tetrad, fine, RayKernel::mino);
                SkyRay ray;
                precise.trace_to_error({&seen, 1}, error, {&ray, 1}, {&measured.ray.error, 1}, most_halvings);
                measured.ray.infinity = ray.infinity;
                measured.ray.outcome = ray.outcome;
                measured.ray.steps = ray.steps;
                measured.ray.hamiltonian_drift = ray.hamiltonian_drift;
            } else {
                measured = measure_generic(chosen, photon, error, settings);
            }
            measured.kernel = tracer.kernel();
            measured.eye_over_energy = -1.0 / photon.momentum.t;
            // The way round is counted on a coarser ray, whose position at infinity is then replaced by the fine one's.
            const RayResult counted = follow_ray(chosen, photon, coarse, swept);
            measured.swept_angle = swept.angle();
            if (measured.ray.outcome == RayOutcome::escaped && counted.outcome == RayOutcome::escaped) {
                measured.swept_angle = swept.angle_with(measured.ray.infinity.direction);
            }
            if (measured.ray.outcome != RayOutcome::escaped) {
                measured.ray.error = std::numeric_limits<double>::quiet_NaN();
            }
            return measured;
        },
        spacetime);
}

} // namespace sim

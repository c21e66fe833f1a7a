#include "render/offline/traced/lane_rays.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace render {

TracedRay traced_ray(sim::RayOutcome outcome, const sim::Asymptotics& infinity, std::uint32_t steps) {
    TracedRay ray;
    ray.steps = static_cast<std::int32_t>(steps);
    switch (outcome) {
    case sim::RayOutcome::escaped:
        ray.direction = infinity.direction;
        ray.wavelength_ratio = infinity.frequency;
        ray.fate = !(ray.wavelength_ratio > 0.0) ? RayFate::not_finite
                   : infinity.side > 0           ? RayFate::sky
                                                 : RayFate::other_sky;
        break;
    case sim::RayOutcome::captured:
        ray.fate = RayFate::captured;
        break;
    case sim::RayOutcome::hit_object:
        ray.fate = RayFate::object;
        break;
    case sim::RayOutcome::step_limit:
        ray.fate = RayFate::step_limit;
        break;
    case sim::RayOutcome::left_chart:
        ray.fate = RayFate::left_chart;
        break;
    case sim::RayOutcome::constraint_drift:
        ray.fate = RayFate::drifted;
        break;
    }
    return ray;
}

float error_from_doubled(const TracedRay& fine, const TracedRay& doubled) {
    if (fine.fate != doubled.fate) {
        return std::numeric_limits<float>::infinity();
    }
    if (is_sky(fine.fate)) {
        // The frequency changes on the way only where nothing is stationary.
        return static_cast<float>(2.0 / 15.0 *
                                  std::max(sim::angle_between(fine.direction, doubled.direction),
                                           std::abs(doubled.wavelength_ratio / fine.wavelength_ratio - 1.0)));
    }
    if (fine.fate == RayFate::disk || fine.fate == RayFate::object) {
        return static_cast<float>(2.0 / 15.0 * glm::length(fine.direction - doubled.direction) /
                                  glm::length(fine.direction));
    }
    return 0.0f;
}

void look_for_disk(const DiskLight& disk, const sim::PlaneCrossings& crossings, TracedRay& ray) {
    for (int i = 0; i < crossings.count; ++i) {
        const sim::PlaneCrossing& crossing = crossings.crossing[static_cast<std::size_t>(i)];
        if (disk.reaches(crossing.radius)) {
            ray.fate = RayFate::disk;
            ray.wavelength_ratio =
                disk.wavelength_ratio(crossing.radius, crossings.frequency, crossings.angular_momentum);
            ray.direction = crossing.radius * glm::dvec3(std::cos(crossing.azimuth), std::sin(crossing.azimuth), 0.0);
            ray.light = disk.seen(crossing.radius, crossing.azimuth, ray.wavelength_ratio);
            return;
        }
    }
}

namespace {

void trace_with(const sim::SkyTracer& tracer, const DiskLight* disk, std::span<const glm::dvec3> directions,
                std::span<TracedRay> rays) {
    std::vector<sim::SkyRay> found(directions.size());
    std::vector<sim::PlaneCrossings> crossings(disk != nullptr ? directions.size() : 0);
    tracer.trace(directions, found, crossings);
    for (std::size_t i = 0; i < found.size(); ++i) {
        rays[i] = traced_ray(found[i].outcome, found[i].infinity, found[i].steps);
        if (disk != nullptr) {
            look_for_disk(*disk, crossings[i], rays[i]);
        }
    }
}

} // namespace

void LaneRays::trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays, std::size_t error_every) const {
    trace_with(tracer_, disk_, directions, rays);
    estimate_errors(directions, rays, error_every, [&](std::span<const glm::dvec3> judged, std::span<TracedRay> into) {
        trace_with(doubled_, disk_, judged, into);
    });
}

} // namespace render

#include "render/offline/traced/lane_rays.h"

#include "sim/spacetime/ray.h"

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
    return is_sky(fine.fate) ? static_cast<float>(2.0 / 15.0 * sim::angle_between(fine.direction, doubled.direction))
                             : 0.0f;
}

void LaneRays::trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays, std::size_t error_every) const {
    std::vector<sim::SkyRay> found(directions.size());
    sim::trace_sky(spacetime_, eye_, tetrad_, directions, settings_, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        rays[i] = traced_ray(found[i].outcome, found[i].infinity, found[i].steps);
    }
    if (error_every == 0) {
        return;
    }
    std::vector<glm::dvec3> judged;
    for (std::size_t i = 0; i < directions.size(); i += error_every) {
        judged.push_back(directions[i]);
    }
    sim::RaySettings doubled = settings_;
    doubled.step *= 2.0;
    found.resize(judged.size());
    sim::trace_sky(spacetime_, eye_, tetrad_, judged, doubled, found);
    for (std::size_t i = 0; i < found.size(); ++i) {
        rays[i * error_every].error =
            error_from_doubled(rays[i * error_every], traced_ray(found[i].outcome, found[i].infinity, found[i].steps));
    }
}

} // namespace render

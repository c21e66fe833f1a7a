#pragma once

#include "render/offline/traced/disk_light.h"
#include "render/offline/traced/traced_ray.h"
#include "sim/spacetime/sky_tracer.h"

#include <vector>

namespace render {

/// Rays on which nothing lies but infinity and a disk, several at once on lanes (sim::SkyTracer).
class LaneRays : public RaySource {
  public:
    /// `disk` may be null; where it is not, the tracer must give crossings. It stays the caller's.
    LaneRays(sim::SkyTracer tracer, sim::SkyTracer with_doubled_step, const DiskLight* disk)
        : tracer_(std::move(tracer)), doubled_(std::move(with_doubled_step)), disk_(disk) {}

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override;

  private:
    sim::SkyTracer tracer_;
    sim::SkyTracer doubled_; ///< for error estimates
    const DiskLight* disk_;
};

/// A result of sim's as a picture's ray, error apart.
TracedRay traced_ray(sim::RayOutcome outcome, const sim::Asymptotics& infinity, std::uint32_t steps);

/// The disk where the ray first crosses its plane, if that is the disk.
void look_for_disk(const DiskLight& disk, const sim::PlaneCrossings& crossings, TracedRay& ray);

/// Error estimate of a ray from the same with twice the step, which is off by 16 times as much (order 4): twice the
/// difference's fifteenth, of the direction or (if larger) the frequency ratio, or of a place over its distance from
/// the chart's origin; infinite when they end differently, 0 for what is dark.
float error_from_doubled(const TracedRay& fine, const TracedRay& doubled);

/// Gives every `error_every`th ray its error estimate (0: none); `trace_doubled(directions, rays)` follows rays with
/// twice the step.
template <class TraceDoubled>
void estimate_errors(std::span<const glm::dvec3> directions, std::span<TracedRay> rays, std::size_t error_every,
                     const TraceDoubled& trace_doubled) {
    if (error_every == 0) {
        return;
    }
    std::vector<glm::dvec3> judged;
    for (std::size_t i = 0; i < directions.size(); i += error_every) {
        judged.push_back(directions[i]);
    }
    std::vector<TracedRay> doubled(judged.size());
    trace_doubled(judged, doubled);
    for (std::size_t i = 0; i < judged.size(); ++i) {
        rays[i * error_every].error = error_from_doubled(rays[i * error_every], doubled[i]);
    }
}

} // namespace render

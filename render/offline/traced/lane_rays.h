#pragma once

#include "render/offline/traced/traced_ray.h"
#include "sim/spacetime/sky_rays.h"

namespace render {

/// Rays on which nothing lies but infinity, several at once on lanes (sim::trace_sky).
class LaneRays : public RaySource {
  public:
    /// Keeps a reference to the spacetime.
    LaneRays(const sim::AnySpacetime& spacetime, const sim::Components<double>& eye, const sim::Tetrad& tetrad,
             const sim::RaySettings& settings)
        : spacetime_(spacetime), eye_(eye), tetrad_(tetrad), settings_(settings) {}

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override;

  private:
    const sim::AnySpacetime& spacetime_;
    sim::Components<double> eye_;
    sim::Tetrad tetrad_;
    sim::RaySettings settings_;
};

/// A result of sim's as a picture's ray, error apart.
TracedRay traced_ray(sim::RayOutcome outcome, const sim::Asymptotics& infinity, std::uint32_t steps);

/// Error estimate of a ray from the same with twice the step, which is off by 16 times as much (order 4): twice the
/// difference's fifteenth; infinite when they end differently, 0 where no direction comes out.
float error_from_doubled(const TracedRay& fine, const TracedRay& doubled);

} // namespace render

#pragma once

#include "render/offline/traced/bent_rays.h"
#include "sim/spacetime/mino_path.h"

#include <memory>

namespace render {

/// Rays around a hole in Mino time on lanes, past objects and a disk.
class HoleRays : public RaySource {
  public:
    /// The hole's eye must fit (sim::fits_mino). `with_time`: the same rays by a kernel that knows the time, for those
    /// that come near what moves and for the last step to a turning hole's horizon; null where `needs_time` is false.
    HoleRays(const sim::AnySpacetime& spacetime, const sim::MinoEye& eye, const sim::RaySettings& settings,
             const TracedMatter& matter, std::shared_ptr<const RaySource> with_time);

    static bool needs_time(const sim::MinoHole& hole, const sim::RaySettings& settings, const TracedMatter& matter);

    void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
               std::size_t error_every) const override;

  private:
    enum class Step : std::uint8_t { free, met, needs_time };
    Step meet(const sim::MinoSegment& segment, double& share, TracedRay& ray) const;
    /// Returns the numbers of rays that were left for `with_time`.
    std::vector<std::size_t> trace_with(double step, std::span<const glm::dvec3> directions,
                                        std::span<TracedRay> rays) const;

    sim::AnySpacetime spacetime_;
    sim::MinoEye eye_;
    sim::RaySettings settings_;
    TracedMatter matter_;
    sim::MinoWatch watch_;
    std::shared_ptr<const RaySource> with_time_;
};

} // namespace render

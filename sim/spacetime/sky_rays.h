#pragma once

#include "sim/spacetime/ray.h"
#include "sim/spacetime/spacetimes.h"

#include <span>

/// Many rays from one eye, several at once in each vector register.
namespace sim {

enum class Precision : std::uint8_t { double_precision, single_precision };

/// What a ray of the eye's sky shows.
struct SkyRay {
    Asymptotics infinity;
    RayOutcome outcome = RayOutcome::step_limit;
    std::uint32_t steps = 0;
    double hamiltonian_drift = 0.0; ///< |H|/(p^t)^2 at the end
};

/// The rays that an eye at `event` with `tetrad` sees from the unit directions `seen` (right, up, back), into `rays`
/// (as many). The generic kernel on lanes: in double precision the same bits as trace_ray on any machine. Single
/// precision serves the holes and the wormhole, to about 1e-5 rad away from the orbit of light; the other spacetimes
/// are always traced in double.
void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               Precision precision = Precision::double_precision);

} // namespace sim

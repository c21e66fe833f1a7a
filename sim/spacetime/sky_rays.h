#pragma once

#include "sim/spacetime/ray.h"
#include "sim/spacetime/spacetimes.h"

#include <functional>
#include <span>
#include <vector>

/// Many rays from one eye, several at once in each vector register.
namespace sim {

enum class Precision : std::uint8_t { double_precision, single_precision };

/// What a ray of the eye's sky shows.
struct SkyRay {
    Asymptotics infinity;
    RayOutcome outcome = RayOutcome::step_limit;
    std::uint32_t steps = 0;
    double hamiltonian_drift = 0.0; ///< |H|/(p^t)^2 at the end
    GeodesicState<double> end{};    ///< last event and momentum, of rays past watched places
};

/// The rays that an eye at `event` with `tetrad` sees from the unit directions `seen` (right, up, back), into `rays`
/// (as many). The generic kernel on lanes: in double precision the same bits as trace_ray on any machine. Single
/// precision serves the holes and the wormhole, to about 1e-5 rad away from the orbit of light; the other spacetimes
/// are always traced in double.
void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               Precision precision = Precision::double_precision);

/// A ball in uniform motion, chart lengths and times.
struct WatchedBall {
    glm::dvec3 centre_at_zero{0.0};
    glm::dvec3 velocity{0.0}; ///< shorter than 1
    double radius = 0.0;
};

/// Where something can be met between the eye and infinity.
struct WatchedPlaces {
    std::vector<WatchedBall> balls;
    bool plane = false; ///< z = 0
};

/// Looks at a step of the ray that eye direction number `ray` has, and may stop it there.
using SegmentVisitor = std::function<Visit(std::size_t ray, const RaySegment& segment)>;

/// As trace_sky in double precision, showing `visit` every step that may touch a watched place (within a quarter more
/// than its curve, for steps that turn by less than a radian), each ray's in order. Stopped rays end as hit_object.
void trace_sky(const AnySpacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
               std::span<const glm::dvec3> seen, const RaySettings& settings, std::span<SkyRay> rays,
               const WatchedPlaces& places, const SegmentVisitor& visit);

/// The same from where light already is: photons (x^mu, p_mu) that are followed into the past until they end or are
/// further than settings.escape_radius.
void trace_photons(const AnySpacetime& spacetime, std::span<const GeodesicState<double>> photons,
                   const RaySettings& settings, std::span<SkyRay> rays, const WatchedPlaces& places,
                   const SegmentVisitor& visit);

} // namespace sim

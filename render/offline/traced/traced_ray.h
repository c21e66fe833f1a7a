#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <span>

namespace render {

/// How a ray that was traced back from the eye ended.
enum class RayFate : std::uint8_t {
    sky,        ///< came from infinity
    other_sky,  ///< came from infinity beyond a wormhole
    captured,   ///< came from a horizon or a singularity: dark
    object,     ///< left a sphere or model
    disk,       ///< left the accretion disk
    step_limit, ///< not known: the steps allowed did not suffice
    left_chart, ///< not known: the coordinates end there
    drifted,    ///< not known: the light-like constraint was lost
    not_finite, ///< not known: a NaN or infinity came up
};

inline bool is_undecided(RayFate fate) {
    return fate >= RayFate::step_limit;
}
inline bool is_sky(RayFate fate) {
    return fate == RayFate::sky || fate == RayFate::other_sky;
}

struct TracedRay {
    RayFate fate = RayFate::captured;
    std::uint32_t object = 0;      ///< which one, for RayFate::object
    std::int32_t steps = 0;        ///< of the integrator
    float error = 0.0f;            ///< estimate, radians of the direction at the far end; see RaySource
    double wavelength_ratio = 0.0; ///< D = lambda_seen / lambda_emitted; 0 where nothing is seen
    glm::dvec3 direction{0.0}; ///< sky: unit, chart axes, where the light comes from; else the place it left, if any
    glm::dvec3 light{0.0};     ///< object and disk: radiance as the eye sees it, linear sRGB
};

/// Traces rays of one camera at one event; called by several threads at once. The result for a direction does not
/// depend on its neighbours in the batch.
class RaySource {
  public:
    RaySource() = default;
    RaySource(const RaySource&) = delete;
    RaySource& operator=(const RaySource&) = delete;
    virtual ~RaySource() = default;

    /// `rays[i]` for the unit head direction `directions[i]` (x right, y up, -z ahead). Every `error_every`th ray, from
    /// the first, gets its error estimate, at the cost of another half or whole ray; 0: none does.
    virtual void trace(std::span<const glm::dvec3> directions, std::span<TracedRay> rays,
                       std::size_t error_every = 0) const = 0;
};

/// Solid angle seen by the eye over solid angle on the sky, of a thin bundle of light around the unit head direction;
/// 0 where the ray comes from nowhere. Called by several threads at once.
using BundleMagnification = std::function<double(const glm::dvec3& direction)>;

} // namespace render

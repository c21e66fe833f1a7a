#pragma once

#include "sim/lorentz.h"

/// Round caps of the sky. Aberration is conformal, so a cap stays a cap: the outline of a sphere is a circle for every
/// observer (Penrose 1959).
namespace sim {

/// All directions within `half_angle` of `axis`, in `Frame`.
template <class Frame>
struct SkyCap {
    Direction<Frame> axis;
    Radians half_angle; ///< in (0, pi)
};

/// The cap in which a moving eye sees a cap of the world's sky. The pair (cos h, c) of half-angle and axis transforms
/// as a four-vector of invariant length sin h.
SkyCap<Head> where_seen(const BoostAndRotation& eye, const SkyCap<World>& cap);

} // namespace sim

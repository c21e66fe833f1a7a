#pragma once

#include "sim/spacetime/geodesic.h"

#include <cstdint>

namespace sim {

/// What kind of place an event is.
enum class Region : std::uint8_t {
    outside,        ///< where an eye can be and signals can leave
    inside_horizon, ///< where an eye can be, but nothing leaves
    singular,       ///< outside the chart or too close to a singularity: nothing can be there
};

/// Light as it is far from everything.
struct Asymptotics {
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit, where the light comes from, in the chart's axes
    double frequency = 1.0;               ///< nu at infinity, measured by an observer at rest there
    int side = 1;                         ///< +1 the eye's usual universe, -1 the far side of a wormhole
};

/// In charts that become Cartesian coordinates at rest far away: the photon moves along p_i, with nu = -p_t.
inline Asymptotics cartesian_asymptotics(const GeodesicState<double>& state) {
    const glm::dvec3 p = space(state.momentum);
    return {-p / chart_radius(state.momentum), -state.momentum.t, 1};
}

} // namespace sim

#pragma once

#include <string_view>
#include <vector>

namespace engine {

/// What one step of a ray of light costs by the ship's integrator, sim::rk4_step.
struct GeodesicCost {
    std::string_view spacetime;
    double nanoseconds_a_step; ///< of processor time, one ray at a time, median
};

/// For holes in their Kerr-Schild charts; medians of `rounds` >= 1.
std::vector<GeodesicCost> geodesic_costs(int rounds);

} // namespace engine

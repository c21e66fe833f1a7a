#pragma once

#include "content/scenario.h"
#include "sim/retarded.h"

#include <string>
#include <vector>

namespace content {

/// Somewhere to fly to: a scenario's beacon, or a star with a name.
struct Destination {
    std::string name;
    sim::InertialObject object; ///< light clock units of the scenario
    int hip = 0;                ///< number in the Hipparcos catalogue; 0: none
    bool is_beacon = false;     ///< it shows a clock
};

/// The autopilot comes to rest this far from a star, on the near side of the way from the world's origin; light-years
/// (63 astronomical units: the star is then a sun, not a point).
inline constexpr double star_clearance_light_years = 1e-3;

/// A star with a name that is no number, and its place in the sky.
struct StarName {
    std::string name;
    int hip = 0;
    glm::dvec3 direction{0.0}; ///< unit, world axes
};

/// The table of names: columns name, hip, right_ascension_deg, declination_deg. Throws sim::BadInput.
std::vector<StarName> load_star_names(const std::filesystem::path& file);

/// Everything that a scenario offers to fly to, its beacons first; stars with names when it shows stars. Lengths are in
/// light clock units of a speed of light of `metres_per_light_unit` scene metres a clock unit. Throws sim::BadInput.
std::vector<Destination> destinations(const Scenario& scenario, double metres_per_light_unit);

/// One of them by name (whatever the case), or a star by "HIP 71683" or "71683". Throws sim::BadInput that names
/// `option`, the text and the nearest name.
Destination find_destination(const std::vector<Destination>& all, const std::string& option, const std::string& text);

} // namespace content

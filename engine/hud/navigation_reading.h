#pragma once

#include <glm/vec3.hpp>

#include <string>
#include <vector>

namespace engine {

/// A clock in the scene as the pilot reads it.
struct ClockReading {
    std::string name;
    double seen = 0.0;             ///< what is read on it now, clock units
    double now = 0.0;              ///< what it shows now in the world
    double wavelength_ratio = 1.0; ///< D; below 1 it is seen to run fast
    glm::dvec3 direction{0.0};     ///< unit, head axes
};

/// The chosen target as the pilot sees it.
struct TargetReading {
    std::string name; ///< "" when there is none
    glm::dvec3 seen{0.0};
    glm::dvec3 now{0.0};
    double distance = 0.0; ///< light clock units, at rest in the target's frame
    double wavelength_ratio = 1.0;
};

/// Everything of a voyage that the instruments show, as plain data.
struct NavigationReading {
    std::vector<ClockReading> clocks;
    TargetReading target;
    std::vector<std::string> assists; ///< those that are on, a line each
    std::string forecast;             ///< of a trip to the target, or what the autopilot does
    bool has_propellant = false;      ///< it can be spent
    double propellant = 0.0;          ///< left, in masses of the ship without it
};

} // namespace engine

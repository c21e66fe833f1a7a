#pragma once

#include "sim/quantities.h"
#include "sim/retarded.h"

#include <cstdint>

/// What assists and autopilot remember from one tick to the next.
namespace sim {

/// Where the autopilot is on its way. From `arrived` on it has handed back the controls.
enum class AutopilotPhase : std::uint64_t {
    off,
    stopping,     ///< to rest first: no two burns lead from here to the target
    accelerating, ///< first burn, aimed again every tick
    coasting,     ///< between the burns
    braking,
    arrived,
    no_target,
    no_propellant,
};

/// Ticks of a trip that are still to come; whole numbers.
struct TripSchedule {
    double wait = 0.0;   ///< while the nose turns to the first burn
    double first = 0.0;  ///< of the first burn
    double coast = 0.0;  ///< between the burns
    double second = 0.0; ///< of the second burn

    double total() const { return wait + first + coast + second; }
    friend bool operator==(const TripSchedule&, const TripSchedule&) = default;
};

struct Guidance {
    InertialObject target;        ///< light clock units; its velocity in c
    std::uint64_t has_target = 0; ///< 1: `target` is one
    Rapidity cruise;              ///< what the cruise assist holds; >= 0
    AutopilotPhase phase = AutopilotPhase::off;
    glm::dvec3 peak{0.0}; ///< velocity part of the four-velocity where the first burn ends, Goal axes
    TripSchedule schedule;
};

/// The autopilot is flying.
constexpr bool is_flying(AutopilotPhase phase) {
    return phase > AutopilotPhase::off && phase < AutopilotPhase::arrived;
}

} // namespace sim

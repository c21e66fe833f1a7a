#include "sim/flight_log.h"

#include "sim/propellant.h"

#include <cmath>

namespace sim {
namespace {

/// Rapidity below which a ship is at rest: well above the roundings of one that has stopped.
constexpr double rest = 1e-12;
/// Slower than this nobody speaks of a flip.
constexpr double slow = 1e-3;

/// The world's motion as the ship sees it: minus its own, vehicle axes, times sinh(rapidity).
glm::dvec3 world_in_vehicle(const VehicleState& state) {
    return four_velocity(inverse(state.world_from_vehicle)).space;
}

double length(const glm::dvec3& v) {
    return std::hypot(v.x, v.y, v.z);
}

bool turned_over(const VehicleState& before, const VehicleState& after) {
    return before.guidance.phase == AutopilotPhase::accelerating &&
           (after.guidance.phase == AutopilotPhase::coasting || after.guidance.phase == AutopilotPhase::braking);
}

} // namespace

std::string_view event_name(FlightEventKind kind) {
    switch (kind) {
    case FlightEventKind::departure:
        return "departure";
    case FlightEventKind::flip:
        return "flip";
    case FlightEventKind::arrival:
        return "arrival";
    case FlightEventKind::propellant_spent:
        return "propellant spent";
    case FlightEventKind::handed_back:
        return "the autopilot hands back";
    }
    return "";
}

std::optional<FlightEvent> FlightLog::watch(const VehicleState& before, const VehicleState& after,
                                            const VehicleSettings& settings) {
    const auto at = [&after](FlightEventKind kind) {
        return FlightEvent{kind, after.tick, after.ship_clock, CoordinateTime(after.event.t)};
    };
    const glm::dvec3 motion = world_in_vehicle(after);
    const double fast = length(motion);
    const int facing = fast > slow && std::abs(motion.z) > 0.2 * fast ? (motion.z > 0.0 ? 1 : -1) : 0;
    const bool flipped = facing * facing_ < 0;
    facing_ = facing != 0 ? facing : facing_;

    const AutopilotPhase was = before.guidance.phase;
    const AutopilotPhase is = after.guidance.phase;
    if (is != was && is == AutopilotPhase::arrived) {
        return at(FlightEventKind::arrival);
    }
    if (rapidity_left(settings, before).value > 0.0 && rapidity_left(settings, after).value == 0.0) {
        return at(FlightEventKind::propellant_spent);
    }
    if (is != was && (is == AutopilotPhase::no_target || is == AutopilotPhase::no_propellant)) {
        return at(FlightEventKind::handed_back);
    }
    if (turned_over(before, after) || (flipped && !is_flying(is) && was != AutopilotPhase::arrived)) {
        return at(FlightEventKind::flip);
    }
    const bool was_at_rest = length(world_in_vehicle(before)) < rest;
    if (was_at_rest && fast >= rest) {
        return at(FlightEventKind::departure);
    }
    if (!was_at_rest && fast < rest && !is_flying(is)) {
        return at(FlightEventKind::arrival);
    }
    return std::nullopt;
}

} // namespace sim

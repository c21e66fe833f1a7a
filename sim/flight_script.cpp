#include "sim/flight_script.h"

#include <cmath>

/// Scripted flights with exact durations, for numbers rather than for pictures.
namespace sim {

double steps_of_segment(const FlightSegment& segment, double rate) {
    // Durations such as 0.1 are not binary fractions: without the allowance 0.1 * 240 may need a 25th step.
    constexpr double allowance = 1e-12;
    return std::max(1.0, std::ceil(segment.duration.value * rate * (1.0 - allowance)));
}

VehicleState fly_segment(const VehicleState& before, const FlightSegment& segment, double rate,
                         VehicleState (*stepper)(const VehicleState&, ProperTime, const Drive&)) {
    const double steps = steps_of_segment(segment, rate);
    const ProperTime duration(segment.duration.value / steps);
    const Drive drive{segment.proper_acceleration, segment.angular_velocity};
    VehicleState state = before;
    for (double i = 0.0; i < steps; i += 1.0) {
        state = stepper(state, duration, drive);
    }
    // A sum of durations would drift by a rounding each step.
    state.ship_clock = before.ship_clock + segment.duration;
    return state;
}

} // namespace sim

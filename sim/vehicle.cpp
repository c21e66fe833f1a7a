#include "sim/vehicle.h"

#include "sim/rk4.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

/// The part of the state that the integrator evolves, as plain doubles.
struct Motion {
    Event displacement; ///< since the step began
    SpinMatrix spin;

    friend Motion operator+(const Motion& p, const Motion& q) {
        return {p.displacement + q.displacement, p.spin + q.spin};
    }
    friend Motion operator*(double s, const Motion& p) { return {s * p.displacement, s * p.spin}; }
};

/// Constant thrust and turn during the tick.
struct EquationOfMotion {
    SpinMatrix half_generator; ///< (a - i w).sigma / 2

    Motion operator()(const Motion& m) const {
        return {four_velocity(Lorentz<World, Vehicle>{m.spin}), m.spin * half_generator};
    }
};

/// Below this the ship counts as at rest: a few roundings of Lambda, gamma - 1 is 1e-28.
constexpr Rapidity rapidity_at_rest{1e-14};

/// c per clock unit: how an unlimited vehicle brakes.
constexpr double unlimited_braking = 1.0;

/// Acceleration in vehicle axes that takes the ship towards rest in the world, within `reach` on each axis, and reaches
/// it at the end of the step if it can.
glm::dvec3 braking_acceleration(const VehicleState& state, ProperTime duration, const glm::dvec3& reach) {
    const BoostAndRotation motion = split(world_from_head(state.world_from_vehicle, glm::dquat(1.0, 0.0, 0.0, 0.0)));
    if (motion.xi < rapidity_at_rest) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 ahead = glm::transpose(motion.boosted_from_head) * motion.along;
    double magnitude = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        if (ahead[i] != 0.0) {
            magnitude = std::min(magnitude, reach[i] / std::abs(ahead[i]));
        }
    }
    if (std::isinf(magnitude)) {
        magnitude = unlimited_braking;
    }
    return -std::min(magnitude, motion.xi.value / duration.value) * ahead;
}

} // namespace

VehicleState step(const VehicleState& before, ProperTime duration, const Drive& drive) {
    const EquationOfMotion equation{0.5 * pauli(drive.proper_acceleration, -drive.angular_velocity)};
    // The derivative does not depend on where the ship is: the event is stepped from zero, so that the displacement
    // keeps its own precision however far the ship has come.
    const Motion after = rk4_step(Motion{{}, before.world_from_vehicle.spin}, duration.value, equation);

    VehicleState state;
    state.tick = before.tick + 1;
    state.ship_clock = before.ship_clock + duration;
    move_to(state, displaced(far_event(before), after.displacement));
    state.world_from_vehicle = {smallest_correction(after.spin)};
    state.felt_acceleration = drive.proper_acceleration;
    state.angular_velocity = drive.angular_velocity;
    return state;
}

VehicleState advance(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    const bool boosted = (control.buttons & ControlFrame::boost) != 0;
    const bool braking = (control.buttons & ControlFrame::brake) != 0;
    const glm::dvec3 reach = (boosted ? settings.boost_factor : 1.0) * settings.maximum_acceleration;
    const glm::dvec3& turn_reach = settings.maximum_turn_rate;
    const ProperTime duration(1.0 / settings.tick_rate);

    Drive drive;
    drive.proper_acceleration = braking ? braking_acceleration(before, duration, reach)
                                        : glm::clamp(control.proper_acceleration, -reach, reach);
    drive.angular_velocity = glm::clamp(control.angular_velocity, -turn_reach, turn_reach);
    VehicleState state = step(before, duration, drive);
    // From the whole number of ticks: a sum of durations would drift by a rounding each tick.
    state.ship_clock = ProperTime(static_cast<double>(state.tick) / settings.tick_rate);
    return state;
}

Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle, const glm::dquat& q) {
    const SpinMatrix n = pauli(glm::dvec3(0.0), -glm::dvec3(q.x, q.y, q.z));
    return world_from_vehicle * Lorentz<Vehicle, Head>{{{q.w + n.a.re, n.a.im}, n.b, n.c, {q.w + n.d.re, n.d.im}}};
}

Event head_event(const VehicleState& state, const glm::dvec3& head_position) {
    return state.event + (state.event_offset + state.world_from_vehicle * FourVector<Vehicle>{0.0, head_position});
}

} // namespace sim

#include "sim/vehicle.h"

#include "sim/rk4.h"

#include <glm/common.hpp>

namespace sim {
namespace {

/// The part of the state that the integrator evolves, as plain doubles.
struct Motion {
    Event event;
    SpinMatrix spin;

    friend Motion operator+(const Motion& p, const Motion& q) { return {p.event + q.event, p.spin + q.spin}; }
    friend Motion operator*(double s, const Motion& p) { return {s * p.event, s * p.spin}; }
};

/// Constant thrust and turn during the tick.
struct EquationOfMotion {
    SpinMatrix half_generator; ///< (a - i w).sigma / 2

    Motion operator()(const Motion& m) const {
        return {four_velocity(Lorentz<World, Vehicle>{m.spin}), m.spin * half_generator};
    }
};

} // namespace

VehicleState advance(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    const double boost = (control.buttons & ControlFrame::boost) != 0 ? settings.boost_factor : 1.0;
    const glm::dvec3 reach = boost * settings.maximum_acceleration;
    const glm::dvec3 a = glm::clamp(control.proper_acceleration, -reach, reach);
    const glm::dvec3 w = glm::clamp(control.angular_velocity, -settings.maximum_turn_rate, settings.maximum_turn_rate);

    const EquationOfMotion equation{0.5 * pauli(a, -w)};
    const Motion after =
        rk4_step(Motion{before.event, before.world_from_vehicle.spin}, 1.0 / settings.tick_rate, equation);

    VehicleState state;
    state.tick = before.tick + 1;
    state.ship_clock = ProperTime(static_cast<double>(state.tick) / settings.tick_rate);
    state.event = after.event;
    state.world_from_vehicle = {smallest_correction(after.spin)};
    state.felt_acceleration = a;
    state.angular_velocity = w;
    return state;
}

Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle, const glm::dquat& q) {
    const SpinMatrix n = pauli(glm::dvec3(0.0), -glm::dvec3(q.x, q.y, q.z));
    return world_from_vehicle * Lorentz<Vehicle, Head>{{{q.w + n.a.re, n.a.im}, n.b, n.c, {q.w + n.d.re, n.d.im}}};
}

Event head_event(const VehicleState& state, const glm::dvec3& head_position) {
    return state.event + state.world_from_vehicle * FourVector<Vehicle>{0.0, head_position};
}

} // namespace sim

#include "sim/vehicle.h"

#include "sim/assists.h"
#include "sim/exact_step.h"
#include "sim/rk4.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace sim {
namespace {

void add_exactly(Complex& value, Complex& remainder, Complex change) {
    sim::add_exactly(value.re, remainder.re, change.re);
    sim::add_exactly(value.im, remainder.im, change.im);
}

void add_exactly(SpinMatrix& value, SpinMatrix& remainder, const SpinMatrix& change) {
    add_exactly(value.a, remainder.a, change.a);
    add_exactly(value.b, remainder.b, change.b);
    add_exactly(value.c, remainder.c, change.c);
    add_exactly(value.d, remainder.d, change.d);
}

/// The state after a step that changes it so.
VehicleState changed(const VehicleState& before, ProperTime duration, const Drive& drive, const Motion& change) {
    VehicleState state = before;
    state.tick = before.tick + 1;
    state.ship_clock = before.ship_clock + duration;
    move_to(state, displaced(far_event(before), change.displacement));
    SpinMatrix& spin = state.world_from_vehicle.spin;
    SpinMatrix& remainder = state.spin_remainder;
    add_exactly(spin, remainder, change.spin_change);
    const Complex det = determinant(spin) + determinant_change(spin, remainder);
    add_exactly(spin, remainder, smallest_correction(spin, det));
    state.felt_acceleration = drive.proper_acceleration;
    state.angular_velocity = drive.angular_velocity;
    return state;
}

} // namespace

VehicleState step(const VehicleState& before, ProperTime duration, const Drive& drive) {
    const EquationOfMotion equation{before.world_from_vehicle.spin, half_generator(drive)};
    return changed(before, duration, drive, rk4_step(Motion{}, duration.value, equation));
}

VehicleState exact_step(const VehicleState& before, ProperTime duration, const Drive& drive) {
    return changed(before, duration, drive, exact_motion(before.world_from_vehicle.spin, duration, drive));
}

VehicleState snap_turned(const VehicleState& before, const VehicleSettings& settings, const ControlFrame& control) {
    const double rate = glm::length(control.angular_velocity);
    if (!control.has(ControlFrame::snap_turn) || rate == 0.0) {
        return before;
    }
    const auto turn = rotation<Vehicle, Vehicle>(Radians(rate / settings.tick_rate), control.angular_velocity / rate);
    VehicleState state = before;
    state.world_from_vehicle = before.world_from_vehicle * turn;
    state.spin_remainder = before.spin_remainder * turn.spin;
    return state;
}

VehicleState advance(const VehicleState& start, const VehicleSettings& settings, const ControlFrame& demand) {
    const VehicleState before = snap_turned(start, settings, demand);
    ControlFrame control = demand;
    if (demand.has(ControlFrame::snap_turn)) {
        control.angular_velocity = glm::dvec3(0.0);
    }
    const AssistedDrive assisted = assisted_drive(before, settings, control);
    VehicleState state = step(before, ProperTime(1.0 / settings.tick_rate), assisted.drive);
    state.rapidity_spent = assisted.rapidity_spent;
    state.guidance = assisted.guidance;
    // From the whole number of ticks: a sum of durations would drift by a rounding each tick.
    state.ship_clock = ProperTime(static_cast<double>(state.tick) / settings.tick_rate);
    return state;
}

bool is_in_range(const VehicleState& state) {
    // |Lambda|^2 = 2 gamma. Written so that a NaN is out of range.
    static const double largest_norm2 = 2.0 * std::cosh(largest_rapidity.value);
    const glm::dvec3& x = state.event.space;
    return frobenius2(state.world_from_vehicle.spin) <= largest_norm2 && std::isfinite(state.event.t) &&
           std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
}

Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle, const glm::dquat& q) {
    const SpinMatrix n = pauli(glm::dvec3(0.0), -glm::dvec3(q.x, q.y, q.z));
    return world_from_vehicle * Lorentz<Vehicle, Head>{{{q.w + n.a.re, n.a.im}, n.b, n.c, {q.w + n.d.re, n.d.im}}};
}

Lorentz<World, Head> world_from_head(const Lorentz<World, Vehicle>& world_from_vehicle,
                                     const glm::dquat& vehicle_from_head, const glm::dvec3& head_velocity) {
    const double speed = glm::length(head_velocity);
    if (speed == 0.0) {
        return world_from_head(world_from_vehicle, vehicle_from_head);
    }
    // The head turns in its own rest frame, whose axes the pure boost carries over from the vehicle's.
    const auto moving =
        world_from_vehicle * boost<Vehicle, Vehicle>(Rapidity(std::atanh(speed)), head_velocity / speed);
    return world_from_head(moving, vehicle_from_head);
}

Event head_event(const VehicleState& state, const glm::dvec3& head_position) {
    return state.event + (state.event_offset + state.world_from_vehicle * FourVector<Vehicle>{0.0, head_position});
}

} // namespace sim

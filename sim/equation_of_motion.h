#pragma once

#include "sim/lorentz.h"

/// dx/dtau = u, dLambda/dtau = 1/2 Lambda (a - i w).sigma, as integrators see it: plain doubles, told as the change
/// since a step began.
namespace sim {

/// Thrust and turn that hold during one step, whatever the limits are.
struct Drive {
    glm::dvec3 proper_acceleration{0.0}; ///< vehicle axes, c per clock unit, finite
    glm::dvec3 angular_velocity{0.0};    ///< vehicle axes, radians per clock unit, finite
};

/// What a step changes.
struct Motion {
    Event displacement;
    SpinMatrix spin_change = SpinMatrix::zero();

    friend Motion operator+(const Motion& p, const Motion& q) {
        return {p.displacement + q.displacement, p.spin_change + q.spin_change};
    }
    friend Motion operator*(double s, const Motion& p) { return {s * p.displacement, s * p.spin_change}; }
};

/// (a - i w).sigma / 2.
constexpr SpinMatrix half_generator(const Drive& drive) {
    return 0.5 * pauli(drive.proper_acceleration, -drive.angular_velocity);
}

/// d/dtau of the motion under constant thrust and turn.
struct EquationOfMotion {
    SpinMatrix spin_before;
    SpinMatrix generator; ///< half_generator of the drive

    Motion operator()(const Motion& m) const {
        const SpinMatrix spin = spin_before + m.spin_change;
        return {four_velocity(Lorentz<World, Vehicle>{spin}), spin * generator};
    }
};

} // namespace sim

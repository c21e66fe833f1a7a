#pragma once

#include "sim/equation_of_motion.h"
#include "sim/quantities.h"

#include <array>

/// Other ways to step a ship under constant thrust and turn, to measure the one that flies (sim/vehicle.h, `step`) by.
/// The exact one is `exact_step` there.
namespace sim {

/// A ship as its event and axes in the world: e_0 is the four-velocity, e_1 to e_3 the vehicle's x, y, z.
struct TetradState {
    Event event;
    std::array<FourVector<World>, 4> axes{FourVector<World>{1.0, {0.0, 0.0, 0.0}},
                                          {0.0, {1.0, 0.0, 0.0}},
                                          {0.0, {0.0, 1.0, 0.0}},
                                          {0.0, {0.0, 0.0, 1.0}}};

    friend TetradState operator+(const TetradState& p, const TetradState& q);
    friend TetradState operator*(double s, const TetradState& p);
};

/// One RK4 step of the four-velocity and the axes themselves: dx = u, du = a^i e_i, de_i = a_i u + w x e_i
/// (Fermi-Walker transport plus the turn). Nothing holds u.u at -1.
TetradState rk4_tetrad_step(const TetradState& before, ProperTime duration, const Drive& drive);

/// The axes made orthonormal again by Gram and Schmidt's steps in the Minkowski product, the four-velocity first.
TetradState orthonormal(const TetradState& state);

/// A ship as its event and Lambda, without remainders.
struct SpinState {
    Event event;
    SpinMatrix spin;
};

/// One RK4 step; nothing holds det Lambda at 1.
SpinState rk4_spin_step(const SpinState& before, ProperTime duration, const Drive& drive);

/// Lambda divided by the root of its determinant: the natural projection, wrong at high speed (spin_matrix.h).
SpinState scaled_to_unit_determinant(const SpinState& state);

/// Lambda with the smallest correction.
SpinState smallest_corrected(const SpinState& state);

} // namespace sim

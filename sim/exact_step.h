#pragma once

#include "sim/equation_of_motion.h"
#include "sim/quantities.h"

/// The motion under constant thrust and turn in closed form. With G = (a - i w).sigma / 2 and q = G^2, a complex
/// number,
///   e^(tau G) = C + S G,   C = cosh(tau sqrt q),   S = sinh(tau sqrt q) / sqrt q,
/// so that Lambda(tau) = Lambda e^(tau G), and the event moves by Lambda (integral of e^(tau G) e^(tau G)^dagger)
/// Lambda^dagger: in vehicle components, with I0, I1, I2 the integrals of |C|^2, conj(C) S and |S|^2,
///   time I0 + I2 (|a|^2 + |w|^2)/4,   space Re(I1) a + Im(I1) w - I2 (a x w)/2.
/// All five are entire functions of q. Where |4 q| tau^2 < 1 they are summed as power series, which also hold where
/// thrust and turn are perpendicular and equal (q = 0, a null rotation); elsewhere nothing cancels.
namespace sim {

/// Where a step of `duration`, of any length > 0, leads to. For thrust against the motion keep the change of rapidity
/// in one step below about 1: the displacement is added up from vehicle components, and a long braking would cancel.
Motion exact_motion(const SpinMatrix& spin_before, ProperTime duration, const Drive& drive);

} // namespace sim

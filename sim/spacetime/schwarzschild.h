#pragma once

#include "sim/spacetime/spherical_hole.h"

namespace sim {

/// The hole without spin or charge (Schwarzschild 1916), of mass M > 0, horizon at r = 2 M:
///   ds^2 = -dt^2 + dx^2 + dy^2 + dz^2 + (2 M/r) (dt + dr)^2.
/// Chart: ingoing Kerr-Schild (kerr_schild.h), r > 0.02 M. t is Schwarzschild's t + 2 M ln|r/(2 M) - 1|.
struct Schwarzschild : SphericalHole {
    explicit Schwarzschild(double mass_) : SphericalHole{{}, mass_, 0.0, HoleRadii::of(mass_, 0.0, 0.0, 3.0 * mass_)} {}
};

} // namespace sim

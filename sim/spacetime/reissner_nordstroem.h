#pragma once

#include "sim/spacetime/spherical_hole.h"

namespace sim {

/// The charged hole without spin (Reissner 1916, Nordstroem 1918), of mass M > 0 and charge |Q| <= M (geometric units):
///   ds^2 = -dt^2 + dx^2 + dy^2 + dz^2 + (2 M/r - Q^2/r^2) (dt + dr)^2.
/// Chart: ingoing Kerr-Schild (kerr_schild.h), outside the inner horizon r_- = M - sqrt(M^2 - Q^2). Light and ships are
/// neutral.
struct ReissnerNordstroem : SphericalHole {
    ReissnerNordstroem(double mass_, double charge_)
        : SphericalHole{{},
                        mass_,
                        charge_,
                        HoleRadii::of(mass_, 0.0, charge_,
                                      0.5 * (3.0 * mass_ + std::sqrt(9.0 * mass_ * mass_ - 8.0 * charge_ * charge_)))} {
    }
};

} // namespace sim

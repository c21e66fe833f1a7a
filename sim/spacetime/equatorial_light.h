#pragma once

namespace sim {

/// The azimuth (Boyer-Lindquist's phi, rad) that light in the plane z = 0 of a hole without charge sweeps on its way
/// from `radius` (lengths in units of M, > 2) in to its periapsis and out to infinity; positive for `impact` = L_z/(E
/// M) > 0. NaN for light that falls in. By quadrature of the first integrals in Legendre's form, to about 1e-13: it
/// shares nothing with the integrators, which are measured against it. Without spin it is
///   2 b/sqrt(s (u_3 - u_1)) (F(pi/2) + ... ) of Legendre's first kind; with u = 1/r, b the impact and
///   (du/dtau)^2 = 1 + (a^2 - b^2) u^2 + s u^3,   s = 2 (b - a)^2,   u_1 < 0 < u_2 <= u_3 its roots,
///   dphi/dtau = b - a + a (1 + a (a - b) u^2)/(1 - 2 u + a^2 u^2)          (Carter 1968; Darwin 1959 for a = 0).
double equatorial_sweep(double spin, double impact, double radius);

/// Carlson's symmetric elliptic integral of the first kind (Carlson 1995): 1/2 int_0^inf dt/sqrt((t + x)(t + y)(t +
/// z)), to rounding. x, y, z >= 0, at most one of them 0.
double carlson_rf(double x, double y, double z);

} // namespace sim

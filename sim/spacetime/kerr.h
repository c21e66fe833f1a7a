#pragma once

#include "sim/spacetime/kerr_schild.h"

namespace sim {

/// The rotating hole (Kerr 1963), of mass M > 0 and spin |a| < M (a = J/M, a length; tested to 0.999 M), turning about
/// +z for a > 0. Chart: ingoing Cartesian Kerr-Schild (kerr_schild.h), outside the inner horizon
/// r_- = M - sqrt(M^2 - a^2). With Boyer-Lindquist's r, theta, phi:
///   x + i y = (r + i a) sin(theta) exp(i phi + i a/(r_+ - r_-) ln((r - r_+)/(r - r_-))),   z = r cos(theta).
struct Kerr : KerrSchildHole<Kerr> {
    double mass;
    double spin;
    HoleRadii radii;

    static constexpr std::array conserved_names{"E", "L_z", "Carter K"};

    Kerr(double mass_, double spin_)
        : mass(mass_), spin(spin_),
          radii(HoleRadii::of(mass_, spin_, 0.0,
                              2.0 * mass_ *
                                  (1.0 + std::cos(2.0 / 3.0 * std::acos(-std::min(std::abs(spin_) / mass_, 1.0)))))) {}

    template <class T>
    KerrSchildField<T> field(const Components<T>& x) const {
        using std::sqrt;
        const T a(spin);
        const T a2 = a * a;
        const T d = x.x * x.x + x.y * x.y + x.z * x.z - a2;
        const T s = sqrt(d * d + T(4.0) * a2 * x.z * x.z);
        const T r = sqrt(T(0.5) * (d + s));
        const T over_sum = T(1.0) / (r * r + a2);
        return {r,
                T(2.0 * mass) * r / s,
                {T(0.0), (r * x.x + a * x.y) * over_sum, (r * x.y - a * x.x) * over_sum, x.z / r}};
    }
    template <class T>
    GeodesicState<T> hamilton_equations(const GeodesicState<T>& state) const {
        return rotating_kerr_schild_equations(mass, spin, state);
    }
    /// Kerr's r.
    template <class T>
    T radius(const Components<T>& x) const {
        using std::sqrt;
        const T a2(spin * spin);
        const T d = x.x * x.x + x.y * x.y + x.z * x.z - a2;
        return sqrt(T(0.5) * (d + sqrt(d * d + T(4.0) * a2 * x.z * x.z)));
    }
    /// See sim::time_reversed; A' = 2 M r/Delta, psi' = 4 M a r/(Delta (r^2 + a^2)). Precondition: reversible.
    template <class T>
    GeodesicState<T> time_reversed(const GeodesicState<T>& state) const {
        using std::atan, std::log;
        const double inner = 2.0 * mass - radii.horizon;
        const double gap = radii.horizon - inner;
        const T r = radius(state.position);
        const T a(spin);
        const T from_horizon = r - T(radii.horizon), from_inner = r - T(inner);
        const T ln_horizon = log(from_horizon), ln_inner = log(from_inner);
        const T rate = T(4.0 * mass) * r / (from_horizon * from_inner);
        const TimeReversal<T> by{T(4.0 * mass / gap) * (T(radii.horizon) * ln_horizon - T(inner) * ln_inner),
                                 T(2.0) * (atan(a / r) + T(spin / gap) * (ln_horizon - ln_inner)), rate,
                                 rate * a / (r * r + a * a)};
        return sim::time_reversed(state, by, [&](const Components<T>& x) { return radius_gradient(r, x); });
    }
    /// E, L_z and Carter's constant K = Q + (L - a E)^2 (Carter 1968), which is p_theta^2 + (a E sin(theta) -
    /// L/sin(theta))^2 for light; here multiplied out, so that nothing is singular on the axis.
    template <class T>
    std::array<T, 3> conserved(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        const T r = radius(x);
        const T a(spin);
        const T energy = -p.t;
        const T angular = x.x * p.y - x.y * p.x;
        const T outward = x.x * p.x + x.y * p.y;
        const T cosine2 = x.z * x.z / (r * r);
        const T carter = (r * r + a * a) * (p.x * p.x + p.y * p.y) - outward * outward - T(2.0) * x.z * outward * p.z +
                         (r * r - x.z * x.z) * p.z * p.z - T(2.0) * a * energy * angular +
                         a * a * energy * energy * (T(1.0) - cosine2) -
                         T(2.0) * hamiltonian(*this, state) * a * a * cosine2;
        return {energy, angular, carter};
    }
    /// Rain, at rest at infinity (Doran 2000): u_t = -1, u_phi = u_theta = 0, u_r = -s/(s + sqrt(r^2 + a^2)) with
    /// s^2 = 2 M r.
    Components<double> falling_covelocity(const Components<double>& x) const {
        const double r = radius(x);
        const double r2 = r * r;
        const double s = std::sqrt(2.0 * mass * r);
        const double inward = -s / (s + std::sqrt(r2 + spin * spin));
        const Components<double> gradient = radius_gradient(r, x);
        return {-1.0, inward * gradient.x, inward * gradient.y, inward * gradient.z};
    }

  private:
    /// d_i r = (x r^3, y r^3, z r (r^2 + a^2))/(r^4 + a^2 z^2).
    template <class T>
    Components<T> radius_gradient(const T& r, const Components<T>& x) const {
        const T r2 = r * r;
        const T a2(spin * spin);
        const T planar = r2 * r / (r2 * r2 + a2 * x.z * x.z);
        return {T(0.0), planar * x.x, planar * x.y, planar * (r2 + a2) / r2 * x.z};
    }
};

} // namespace sim

#pragma once

#include "sim/spacetime/kerr_schild.h"

namespace sim {

/// What Schwarzschild and Reissner-Nordstroem share: f = 2 M/r - Q^2/r^2, n = x/r.
struct SphericalHole : KerrSchildHole<SphericalHole> {
    double mass = 1.0;
    double charge = 0.0;
    HoleRadii radii;

    static constexpr std::array conserved_names{"E", "L_x", "L_y", "L_z"};

    template <class T>
    KerrSchildField<T> field(const Components<T>& x) const {
        const T r = chart_radius(x);
        const T u = T(1.0) / r;
        return {r, u * (T(2.0 * mass) - T(charge * charge) * u), u * x};
    }
    template <class T>
    GeodesicState<T> hamilton_equations(const GeodesicState<T>& state) const {
        return spherical_kerr_schild_equations(mass, charge, state);
    }
    /// See sim::time_reversed; A' = (2 M r - Q^2)/Delta with Delta = (r - r_+)(r - r_-) and 2 M r_+- - Q^2 = r_+-^2.
    /// Precondition: reversible.
    template <class T>
    GeodesicState<T> time_reversed(const GeodesicState<T>& state) const {
        using std::log;
        const double outer = radii.horizon;
        const double inner = 2.0 * mass - outer;
        const T r = chart_radius(state.position);
        const T from_horizon = r - T(outer), from_inner = r - T(inner);
        const T time =
            T(2.0 / (outer - inner)) * (T(outer * outer) * log(from_horizon) - T(inner * inner) * log(from_inner));
        const T rate = T(2.0) * (T(2.0 * mass) * r - T(charge * charge)) / (from_horizon * from_inner);
        return sim::time_reversed(state, TimeReversal<T>{time, T(0.0), rate, T(0.0)}, [&](const Components<T>& x) {
            const T u = T(1.0) / r;
            return Components<T>{T(0.0), u * x.x, u * x.y, u * x.z};
        });
    }
    template <class T>
    T radius(const Components<T>& x) const {
        return chart_radius(x);
    }
    template <class T>
    std::array<T, 4> conserved(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        return {-p.t, x.y * p.z - x.z * p.y, x.z * p.x - x.x * p.z, x.x * p.y - x.y * p.x};
    }
    /// Rain, at rest at infinity (Painleve 1921): u_t = -1, u_r = -s/(s + r) with s^2 = 2 M r - Q^2.
    Components<double> falling_covelocity(const Components<double>& x) const {
        const double r = chart_radius(x);
        const double s = std::sqrt(std::max(2.0 * mass * r - charge * charge, 0.0));
        const double inward = -s / (s + r) / r;
        return {-1.0, inward * x.x, inward * x.y, inward * x.z};
    }
};

} // namespace sim

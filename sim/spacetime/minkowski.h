#pragma once

#include "sim/spacetime/asymptotics.h"

namespace sim {

/// Flat spacetime: ds^2 = -dt^2 + dx^2 + dy^2 + dz^2. Chart: Cartesian, everywhere. (Minkowski 1908.)
struct Minkowski {
    static constexpr std::array conserved_names{"E", "p_x", "p_y", "p_z"};
    static constexpr bool may_have_horizon = false;
    static constexpr bool fits_single_precision = true;

    template <class T>
    SymmetricTensor<T> metric(const Components<T>& /*x*/) const {
        return diagonal(T(-1.0), T(1.0), T(1.0), T(1.0));
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        return metric(x);
    }
    template <class T>
    GeodesicState<T> hamilton_equations(const GeodesicState<T>& state) const {
        const auto& p = state.momentum;
        return {{-p.t, p.x, p.y, p.z}, {}};
    }
    /// h^2 = 1 + r^2: any step is exact.
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        const Components<T>& x = state.position;
        const Components<T>& velocity = rate.position;
        using std::sqrt;
        return sqrt(T(1.0) + x.x * x.x + x.y * x.y + x.z * x.z) / velocity.t;
    }
    template <class T>
    T remoteness(const Components<T>& x) const {
        return chart_radius(x);
    }
    template <class T>
    std::array<T, 4> conserved(const GeodesicState<T>& state) const {
        const auto& p = state.momentum;
        return {-p.t, p.x, p.y, p.z};
    }
    Region region(const Components<double>& /*x*/) const { return Region::outside; }
    /// Everywhere.
    double flat_beyond(double eye_distance = 0.0, double /*error*/ = 1e-13) const {
        return std::max(1.0, 2.0 * eye_distance);
    }
    Components<double> falling_covelocity(const Components<double>& /*x*/) const { return {-1.0, 0.0, 0.0, 0.0}; }
    Asymptotics asymptotics(const GeodesicState<double>& state) const { return cartesian_asymptotics(state); }
};

} // namespace sim

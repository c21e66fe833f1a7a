#pragma once

#include "sim/spacetime/asymptotics.h"
#include "sim/spacetime/expression.h"

#include <algorithm>
#include <string>

namespace sim {

/// A spacetime of somebody's own: ten expressions for g_{mu nu}(t, x, y, z), differentiated automatically. Chart: the
/// coordinates in which they are written, Cartesian and at rest far away. Cited and limited by who wrote it; a horizon
/// shows itself by blueshift without end (RaySettings::blueshift_limit).
struct CustomSpacetime {
    std::string name;
    std::vector<Expression> components; ///< ten, as SymmetricTensor::upper
    double smallest_length = 1.0;       ///< over which the metric changes near the origin
    double flat_radius = 1e4;           ///< beyond which it is taken for flat

    static constexpr std::array conserved_names{"E if nothing depends on t"};
    static constexpr bool may_have_horizon = true;
    static constexpr bool fits_single_precision = false;

    template <class T>
    SymmetricTensor<T> metric(const Components<T>& x) const {
        const std::array<T, 4> coordinates{x.t, x.x, x.y, x.z};
        SymmetricTensor<T> g;
        for (std::size_t i = 0; i < g.upper.size(); ++i) {
            g.upper[i] = components[i].at(coordinates);
        }
        return g;
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        return inverse(metric(x));
    }
    /// h^2 = l^2 + r^2 in coordinate time, l the smallest length.
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        const Components<T>& x = state.position;
        const Components<T>& velocity = rate.position;
        using std::sqrt;
        return sqrt(T(smallest_length * smallest_length) + x.x * x.x + x.y * x.y + x.z * x.z) / velocity.t;
    }
    template <class T>
    T remoteness(const Components<T>& x) const {
        return chart_radius(x);
    }
    bool stationary() const {
        return std::ranges::none_of(components, [](const Expression& each) { return each.depends_on(0); });
    }
    template <class T>
    std::array<T, 1> conserved(const GeodesicState<T>& state) const {
        return {stationary() ? -state.momentum.t : T(0.0)};
    }
    /// Regular where the metric has the signature (-,+,+,+) and finite components.
    Region region(const Components<double>& x) const;
    double flat_beyond(double eye_distance = 0.0, double /*error*/ = 1e-13) const {
        return std::max(flat_radius, 2.0 * eye_distance);
    }
    /// At rest with respect to the slices of constant t.
    Components<double> falling_covelocity(const Components<double>& x) const {
        return {-1.0 / std::sqrt(-inverse_metric(x)(0, 0)), 0.0, 0.0, 0.0};
    }
    Asymptotics asymptotics(const GeodesicState<double>& state) const { return cartesian_asymptotics(state); }
};

} // namespace sim

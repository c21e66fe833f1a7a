#pragma once

#include "sim/rk4.h"
#include "sim/spacetime/components.h"
#include "sim/spacetime/dual.h"

/// Geodesics in Hamiltonian form (PHYSICS 7; MTW exercise 25.2): H = 1/2 g^{mu nu}(x) p_mu p_nu,
///   dx^mu/dlambda = g^{mu nu} p_nu,   dp_mu/dlambda = -1/2 d_mu g^{ab} p_a p_b.
/// H = 0 for light (lambda affine), H = -1/2 for a body when p_mu = u_mu (lambda is proper time).
///
/// A spacetime is a plain struct with
///   metric<T>(x), inverse_metric<T>(x)      g_{mu nu}, g^{mu nu} in its chart;
///   step_scale<T>(state, its rate)          h > 0 in dlambda = h ds, so that equal steps in s are equally accurate;
///   hamilton_equations<T>(state)            optional: the two equations by hand, where that is faster;
///   time_reversed<T>(state), reversible(x)  optional: a second chart, smooth for light on its way in to a hole
///                                           (kerr_schild.h).
/// Nothing else here knows the metric.
namespace sim {

/// A point of phase space; also its derivative. x^mu is `position`, p_mu is `momentum`.
template <class T>
struct GeodesicState {
    Components<T> position;
    Components<T> momentum;

    friend GeodesicState operator+(const GeodesicState& a, const GeodesicState& b) {
        return {a.position + b.position, a.momentum + b.momentum};
    }
    friend GeodesicState operator*(const T& s, const GeodesicState& a) { return {s * a.position, s * a.momentum}; }
};

/// H = 1/2 g^{mu nu} p_mu p_nu.
template <class Spacetime, class T>
T hamiltonian(const Spacetime& spacetime, const GeodesicState<T>& state) {
    return T(0.5) * contract(spacetime.inverse_metric(state.position) * state.momentum, state.momentum);
}

/// Hamilton's equations by automatic differentiation of the inverse metric.
template <class Spacetime, class T>
GeodesicState<T> differentiated_hamilton_equations(const Spacetime& spacetime, const GeodesicState<T>& state) {
    using D = Dual<T, 4>;
    Components<D> x;
    for (int mu = 0; mu < 4; ++mu) {
        x[mu] = D::variable(state.position[mu], mu);
    }
    const SymmetricTensor<D> g = spacetime.inverse_metric(x);
    GeodesicState<T> rate;
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
            rate.position[a] = rate.position[a] + g(a, b).value * state.momentum[b];
        }
        for (int b = a; b < 4; ++b) {
            const T weight = T(a == b ? -0.5 : -1.0) * state.momentum[a] * state.momentum[b];
            for (int mu = 0; mu < 4; ++mu) {
                rate.momentum[mu] = rate.momentum[mu] + weight * g(a, b).slope[static_cast<std::size_t>(mu)];
            }
        }
    }
    return rate;
}

/// d(x, p)/dlambda.
template <class Spacetime, class T>
GeodesicState<T> hamilton_equations(const Spacetime& spacetime, const GeodesicState<T>& state) {
    if constexpr (requires { spacetime.hamilton_equations(state); }) {
        return spacetime.hamilton_equations(state);
    } else {
        return differentiated_hamilton_equations(spacetime, state);
    }
}

/// d(x, p)/ds, with s the spacetime's own parameter: dlambda = h(x) ds.
template <class Spacetime, class T>
GeodesicState<T> rate_in_own_parameter(const Spacetime& spacetime, const GeodesicState<T>& state) {
    const GeodesicState<T> rate = hamilton_equations(spacetime, state);
    return spacetime.step_scale(state, rate) * rate;
}

/// One fixed step `step` of s; negative steps go into the past.
template <class Spacetime, class T>
GeodesicState<T> geodesic_step(const Spacetime& spacetime, const GeodesicState<T>& state, double step) {
    return rk4_step(state, step, [&](const GeodesicState<T>& at) { return rate_in_own_parameter(spacetime, at); });
}

} // namespace sim

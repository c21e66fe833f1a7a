#pragma once

#include "sim/spacetime/asymptotics.h"

namespace sim {

/// The traversable wormhole of Ellis (1973) and Morris & Thorne (1988, their simplest), throat radius b > 0:
///   ds^2 = -dt^2 + dl^2 + (b^2 + l^2) dOmega^2 = -dt^2 + psi^2 (dx^2 + dy^2 + dz^2),   psi = 1 + b^2/(4 rho^2).
/// Chart: isotropic Cartesian, rho = |x|, l = rho - b^2/(4 rho): one chart for both universes. rho > b/2 is this side;
/// the far side lies within, its infinity at the origin, and the map x -> b^2 x/(4 rho^2) turns it inside out: the same
/// kind of coordinates for one who lives there (`other_side`).
struct Wormhole {
    double throat; ///< b

    static constexpr std::array conserved_names{"E", "L_x", "L_y", "L_z"};
    static constexpr bool may_have_horizon = false;
    static constexpr bool fits_single_precision = true;

    template <class T>
    T stretch(const Components<T>& x) const {
        return T(1.0) + T(0.25 * throat * throat) / (x.x * x.x + x.y * x.y + x.z * x.z);
    }
    template <class T>
    SymmetricTensor<T> metric(const Components<T>& x) const {
        const T psi = stretch(x);
        return diagonal(T(-1.0), psi * psi, psi * psi, psi * psi);
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        const T over_psi = T(1.0) / stretch(x);
        const T g = over_psi * over_psi;
        return diagonal(T(-1.0), g, g, g);
    }
    /// dp_i = p^2 d_i(psi)/psi^3 with d_i psi = -b^2 x_i/(2 rho^4).
    template <class T>
    GeodesicState<T> hamilton_equations(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        const T over_rho2 = T(1.0) / (x.x * x.x + x.y * x.y + x.z * x.z);
        const T over_psi = T(1.0) / (T(1.0) + T(0.25 * throat * throat) * over_rho2);
        const T g = over_psi * over_psi;
        const T pull =
            T(-0.5 * throat * throat) * (p.x * p.x + p.y * p.y + p.z * p.z) * g * over_psi * over_rho2 * over_rho2;
        return {{-p.t, g * p.x, g * p.y, g * p.z}, {T(0.0), pull * x.x, pull * x.y, pull * x.z}};
    }
    /// h = R (1 + R/(10 b + R)) with R^2 = b^2 + l^2, alike on both sides.
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        const Components<T>& x = state.position;
        const Components<T>& velocity = rate.position;
        const T r = remoteness(x);
        return r * (T(1.0) + r / (T(10.0 * throat) + r)) / velocity.t;
    }
    /// sqrt(b^2 + l^2) = rho psi.
    template <class T>
    T remoteness(const Components<T>& x) const {
        return chart_radius(x) * stretch(x);
    }
    template <class T>
    std::array<T, 4> conserved(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        return {-p.t, x.y * p.z - x.z * p.y, x.z * p.x - x.x * p.z, x.x * p.y - x.y * p.x};
    }
    Region region(const Components<double>& x) const {
        return chart_radius(x) > 0.0 ? Region::outside : Region::singular;
    }
    /// Chart length beyond which light that an eye at `eye_distance` from the origin sees is bent by less than `error`
    /// (rad): b^2 d/(6 r^3) for
    /// light that passes at the distance d.
    double flat_beyond(double eye_distance = 0.0, double error = 1e-13) const {
        const double d = std::max(eye_distance, 10.0 * throat);
        return std::max(std::cbrt(throat * throat * d / (6.0 * error)), 2.0 * d);
    }
    /// g_tt = -1: who is at rest falls freely.
    Components<double> falling_covelocity(const Components<double>& /*x*/) const { return {-1.0, 0.0, 0.0, 0.0}; }

    /// +1 on this side of the throat, -1 on the far side.
    int side(const glm::dvec3& x) const { return x.x * x.x + x.y * x.y + x.z * x.z < 0.25 * throat * throat ? -1 : 1; }
    /// The same place in the coordinates of the other side's inhabitants. Its own inverse.
    glm::dvec3 other_side(const glm::dvec3& x) const {
        return (0.25 * throat * throat / (x.x * x.x + x.y * x.y + x.z * x.z)) * x;
    }
    /// p_i in the coordinates of the side where the ray is, but for a positive factor.
    template <class T>
    Components<T> far_momentum(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        const T rho2 = x.x * x.x + x.y * x.y + x.z * x.z;
        if (plain(rho2) >= 0.25 * throat * throat) {
            return p;
        }
        const T twice = T(2.0) * (x.x * p.x + x.y * p.y + x.z * p.z) / rho2;
        return {p.t, p.x - twice * x.x, p.y - twice * x.y, p.z - twice * x.z};
    }
    /// On the far side the direction is told in that side's own coordinates.
    Asymptotics asymptotics(const GeodesicState<double>& state) const {
        Asymptotics result = cartesian_asymptotics({state.position, far_momentum(state)});
        result.side = side(space(state.position));
        return result;
    }
    /// The l of a static observer's place and back: rho = (l + sqrt(l^2 + b^2))/2.
    double isotropic_radius(double l) const { return 0.5 * (l + std::hypot(l, throat)); }
};

} // namespace sim

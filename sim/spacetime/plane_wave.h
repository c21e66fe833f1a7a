#pragma once

#include "sim/spacetime/asymptotics.h"

#include <numbers>

namespace sim {

/// A pulse of plane gravitational waves along +z, in transverse traceless coordinates (MTW 35.2):
///   ds^2 = -dt^2 + (1 + h_+) dx^2 + (1 - h_+) dy^2 + 2 h_x dx dy + dz^2,   u = t - z,
///   h_+ = A_+ W cos(2 pi u/lambda),  h_x = A_x W sin(2 pi u/lambda),  W = exp(-u^2/(2 w^2)),  w = cycles lambda.
/// A_+ = A_x is circularly polarised. Chart: everywhere; flat before and after the pulse. The field equations hold to
/// first order in A (up to 0.5 is allowed); geodesics in the metric are exact. Bodies at rest stay at rest.
struct PlaneWave {
    double plus;
    double cross;
    double wavelength;
    double cycles;

    static constexpr std::array conserved_names{"E - p_z", "p_x", "p_y"};
    static constexpr bool may_have_horizon = false;
    static constexpr bool fits_single_precision = false;

    /// h_+ and h_x.
    template <class T>
    std::array<T, 2> strain(const Components<T>& x) const {
        using std::cos, std::exp, std::sin;
        const double width = cycles * wavelength;
        const T u = x.t - x.z;
        const T envelope = exp(T(-0.5 / (width * width)) * u * u);
        const T phase = T(2.0 * std::numbers::pi / wavelength) * u;
        return {T(plus) * envelope * cos(phase), T(cross) * envelope * sin(phase)};
    }
    template <class T>
    SymmetricTensor<T> metric(const Components<T>& x) const {
        const auto [h_plus, h_cross] = strain(x);
        SymmetricTensor<T> g = diagonal(T(-1.0), T(1.0) + h_plus, T(1.0) - h_plus, T(1.0));
        g(1, 2) = h_cross;
        return g;
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        const auto [h_plus, h_cross] = strain(x);
        const T over = T(1.0) / (T(1.0) - h_plus * h_plus - h_cross * h_cross);
        SymmetricTensor<T> g = diagonal(T(-1.0), (T(1.0) - h_plus) * over, (T(1.0) + h_plus) * over, T(1.0));
        g(1, 2) = -h_cross * over;
        return g;
    }
    /// Even steps in the phase u, longer outside the pulse: h = l(u)/(du/dlambda), l^2 = (lambda/2)^2 +
    /// u^4/(16 (64 w^2 + u^2)). The small addition to du/dlambda lets light that travels along with the wave move.
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        const Components<T>& x = state.position;
        const Components<T>& velocity = rate.position;
        using std::sqrt;
        const T u = x.t - x.z;
        const T u2 = u * u;
        const double width = cycles * wavelength;
        const T length2 = T(0.25 * wavelength * wavelength) + T(1.0 / 16.0) * u2 * u2 / (T(64.0 * width * width) + u2);
        return sqrt(length2) / (velocity.t - velocity.z + T(1e-9) * velocity.t);
    }
    /// |u|, and a trace of the distance for light that travels along with the wave and never leaves it.
    template <class T>
    T remoteness(const Components<T>& x) const {
        using std::sqrt;
        const T u = x.t - x.z;
        return sqrt(u * u + T(1e-18) * (x.x * x.x + x.y * x.y + x.z * x.z));
    }
    template <class T>
    std::array<T, 3> conserved(const GeodesicState<T>& state) const {
        const auto& p = state.momentum;
        return {-p.t - p.z, p.x, p.y};
    }
    Region region(const Components<double>& /*x*/) const { return Region::outside; }
    /// Chart length beyond which light that an eye at `eye_distance` from the origin sees is bent by less than `error`
    /// (rad): where the
    /// envelope is below a tenth of that.
    double flat_beyond(double eye_distance = 0.0, double error = 1e-13) const {
        return std::max(cycles * wavelength * std::sqrt(2.0 * std::log(10.0 / error)), 2.0 * eye_distance);
    }
    Components<double> falling_covelocity(const Components<double>& /*x*/) const { return {-1.0, 0.0, 0.0, 0.0}; }
    Asymptotics asymptotics(const GeodesicState<double>& state) const { return cartesian_asymptotics(state); }
};

} // namespace sim

#pragma once

#include "sim/spacetime/asymptotics.h"
#include "sim/spacetime/exponential.h"

#include <glm/geometric.hpp>

#include <optional>

namespace sim {

/// The warp bubble (Alcubierre 1994), moving along +x at speed v >= 0 (above 1 too) with radius R and wall of
/// thickness 1/sigma:
///   ds^2 = -dt^2 + (dx - v f dt)^2 + dy^2 + dz^2,   r_s^2 = (x - v t)^2 + y^2 + z^2,
///   f(r_s) = (tanh(sigma (r_s + R)) - tanh(sigma (r_s - R)))/(2 tanh(sigma R))
///          = (1 + C)/(cosh(2 sigma r_s) + C),   C = cosh(2 sigma R): smooth at the centre, without cancellation.
/// Chart: the outside's Cartesian coordinates, everywhere; the bridge is at x = v t. Given, not caused: no known matter
/// makes it, and the bubble never changes its speed. sigma R up to 100.
struct Alcubierre {
    double speed;         ///< v
    double bubble_radius; ///< R
    double wall;          ///< sigma, 1/length
    double wall_cosh;     ///< C

    static constexpr std::array conserved_names{"E - v p_x", "L_x"};
    static constexpr bool may_have_horizon = true; ///< at v > 1
    static constexpr bool fits_single_precision = false;

    Alcubierre(double v, double r, double sigma)
        : speed(v), bubble_radius(r), wall(sigma), wall_cosh(std::cosh(2.0 * sigma * r)) {}

    template <class T>
    struct Profile {
        Components<T> from_centre;
        T value;         ///< f
        T slope_over_rs; ///< f'(r_s)/r_s
    };

    template <class T>
    Profile<T> profile(const Components<T>& x) const {
        using std::sqrt;
        const Components<T> d{T(0.0), x.x - T(speed) * x.t, x.y, x.z};
        // Beyond e^300 the wall's tail is 0 to rounding; the bound keeps cosh finite. The offset keeps the root's
        // derivative finite at the centre, where sinh(s)/s is taken from its series.
        const T s2 = T(4.0 * wall * wall) * (d.x * d.x + d.y * d.y + d.z * d.z) + T(1e-60);
        const T s = select(s2 > T(9e4), T(300.0), sqrt(s2));
        const T grown = exponential(s);
        const T shrunk = T(1.0) / grown;
        T series(1.0);
        for (const double divisor : {110.0, 72.0, 42.0, 20.0, 6.0}) {
            series = T(1.0) + T(1.0 / divisor) * s2 * series;
        }
        const T sinh_over_s = select(s2 < T(0.1), series, T(0.5) * (grown - shrunk) / s);
        const T over = T(1.0) / (T(0.5) * (grown + shrunk) + T(wall_cosh));
        const T f = T(1.0 + wall_cosh) * over;
        return {d, f, T(-4.0 * wall * wall) * sinh_over_s * f * over};
    }
    template <class T>
    SymmetricTensor<T> metric(const Components<T>& x) const {
        const T vf = T(speed) * profile(x).value;
        SymmetricTensor<T> g = diagonal(vf * vf - T(1.0), T(1.0), T(1.0), T(1.0));
        g(0, 1) = -vf;
        return g;
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        const T vf = T(speed) * profile(x).value;
        SymmetricTensor<T> g = diagonal(T(-1.0), T(1.0) - vf * vf, T(1.0), T(1.0));
        g(0, 1) = -vf;
        return g;
    }
    /// 2 H = -(p_t + v f p_x)^2 + p_x^2 + p_y^2 + p_z^2.
    template <class T>
    GeodesicState<T> hamilton_equations(const GeodesicState<T>& state) const {
        const auto& p = state.momentum;
        const Profile<T> bubble = profile(state.position);
        const T v(speed);
        const T vf = v * bubble.value;
        const T pi = p.t + vf * p.x;
        const T pull = pi * v * p.x * bubble.slope_over_rs;
        const auto& d = bubble.from_centre;
        return {{-pi, p.x - vf * pi, p.y, p.z}, {-v * pull * d.x, pull * d.x, pull * d.y, pull * d.z}};
    }
    /// h^2 = 1/sigma^2 + (r_s^2 - R^2)^2/(2 (r_s^2 + R^2)), over the speeds at which light meets the wall: fine steps
    /// in the wall, long ones away from it.
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        const Components<T>& x = state.position;
        const Components<T>& velocity = rate.position;
        using std::sqrt;
        const T r2 = distance2(x);
        const T big2(bubble_radius * bubble_radius);
        const T from_wall = r2 - big2;
        return sqrt(T(1.0 / (wall * wall)) + T(0.5) * from_wall * from_wall / (r2 + big2)) /
               (T(1.0 + speed) * velocity.t);
    }
    /// r_s.
    template <class T>
    T remoteness(const Components<T>& x) const {
        using std::sqrt;
        return sqrt(distance2(x));
    }
    template <class T>
    std::array<T, 2> conserved(const GeodesicState<T>& state) const {
        const auto& [x, p] = state;
        return {-p.t - T(speed) * p.x, x.y * p.z - x.z * p.y};
    }
    Region region(const Components<double>& /*x*/) const { return Region::outside; }
    /// Chart length beyond which light that an eye at `eye_distance` from the origin sees is bent by less than `error`
    /// (rad): where f is below a thousandth of that, for light that the bubble outruns is bent the more.
    double flat_beyond(double eye_distance = 0.0, double error = 1e-13) const {
        return std::max(flat_radius(error), 2.0 * eye_distance);
    }
    /// r_s beyond which light goes straight to `error` (rad).
    double flat_radius(double error) const { return bubble_radius + 0.5 * std::log(1e3 / error) / wall; }
    /// How long before now, in t, light at `state` outside flat_radius was last at it; never: nothing.
    std::optional<double> time_since_flat_radius(const GeodesicState<double>& state, double radius) const {
        const glm::dvec3 offset = space(state.position) - glm::dvec3(speed * state.position.t, 0.0, 0.0);
        const glm::dvec3 motion =
            space(state.momentum) / chart_radius(state.momentum) - glm::dvec3(speed, 0.0, 0.0); // seen from the centre
        // |offset - s motion| = radius, the first s > 0.
        const double a = glm::dot(motion, motion);
        const double b = glm::dot(offset, motion);
        const double c = glm::dot(offset, offset) - radius * radius;
        const double discriminant = b * b - a * c;
        if (!(b > 0.0 && discriminant > 0.0)) {
            return std::nullopt;
        }
        return c / (b + std::sqrt(discriminant));
    }
    /// Alcubierre's free fall: u_mu = -d_mu t; on the bridge, at rest in the ship.
    Components<double> falling_covelocity(const Components<double>& /*x*/) const { return {-1.0, 0.0, 0.0, 0.0}; }
    Asymptotics asymptotics(const GeodesicState<double>& state) const { return cartesian_asymptotics(state); }

  private:
    template <class T>
    T distance2(const Components<T>& x) const {
        const T along = x.x - T(speed) * x.t;
        return along * along + x.y * x.y + x.z * x.z;
    }
};

} // namespace sim

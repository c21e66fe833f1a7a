#pragma once

#include "sim/spacetime/asymptotics.h"
#include "sim/spacetime/geodesic.h"

#include <algorithm>

/// Black holes in Cartesian Kerr-Schild form (Kerr & Schild 1965; Debney, Kerr & Schild 1969 for charge):
///   g_{mu nu} = eta_{mu nu} + f l_mu l_nu,   l_mu = (1, n),   f = (2 M r - Q^2) / S,   S = sqrt(D^2 + 4 a^2 z^2),
///   D = x^2 + y^2 + z^2 - a^2,   r^2 = (D + S) / 2,
///   n = ((r x + a y)/(r^2 + a^2), (r y - a x)/(r^2 + a^2), z/r).
/// No singular axis, regular at the future horizon: what falls in crosses it, and light that reaches an eye from near
/// the hole is followed back towards the horizon, which it never reaches. z is the axis of spin. What the three holes
/// share is here; each supplies its f, r and their derivatives as a `KerrSchildField`.
namespace sim {

/// The radii of a hole, lengths in the unit of its mass.
struct HoleRadii {
    double horizon = 2.0;      ///< outer, r_+
    double innermost = 0.02;   ///< the inner horizon, or 0.02 M from the singularity: nothing deeper is modelled
    double photon_orbit = 3.0; ///< the innermost circular orbit of light (prograde): what falls below it is caught

    static HoleRadii of(double mass, double spin, double charge, double photon_orbit) {
        const double root = std::sqrt(std::max(mass * mass - spin * spin - charge * charge, 0.0));
        return {mass + root, std::max(mass - root, 0.02 * mass), photon_orbit};
    }

    Region region(double r) const {
        return r > horizon ? Region::outside : r > innermost ? Region::inside_horizon : Region::singular;
    }

    /// Whether r is where the time-reversed chart can be told from this one: outside the horizon, and not so close that
    /// rounding swells; nor where both horizons (nearly) fall together.
    bool reversible(double r) const { return r > 1.001 * horizon && horizon - innermost > 1e-4 * horizon; }

    /// The r at which light followed into the past counts as coming from the horizon. With nothing to be met below
    /// the orbit of light that is already certain there; else it is followed to 2 % of that distance.
    double capture_radius(bool nothing_below) const {
        return nothing_below ? photon_orbit : horizon + 0.02 * (photon_orbit - horizon);
    }
};

/// h = 4/3 r (1 + 2 r^2/(100 M^2 + r^2))/(1 + |p|), and 2/3 of that in the time-reversed chart: steps shrink towards
/// the hole with r, stay gentle where light climbs out of it (|p| is large there) and treble in proportion to r further
/// out. On the way in, an error grows with every turn that is still to come; on the way out it has none.
template <class T>
T hole_step_scale(double mass, const T& r, const GeodesicState<T>& state, const GeodesicState<T>& rate) {
    using std::sqrt;
    const auto& p = state.momentum;
    const T r2 = r * r;
    const T hundred(100.0 * mass * mass);
    const T factor = select(rate.position.t > T(0.0), T(4.0 / 3.0), T(8.0 / 9.0));
    return factor * r * (hundred + T(3.0) * r2) / ((hundred + r2) * (T(1.0) + sqrt(p.x * p.x + p.y * p.y + p.z * p.z)));
}

/// What a hole's time-reversed chart needs beside the place: how its coordinates depend on r.
template <class T>
struct TimeReversal {
    T time;         ///< 2 A, t -> 2 A - t
    T azimuth;      ///< psi, the planar part is mirrored and turned by it
    T time_rate;    ///< 2 A'(r)
    T azimuth_rate; ///< psi'(r)
};

/// What happens to (x^mu, p_mu) in the isometry t -> -t, phi -> -phi (Boyer and Lindquist's) of a hole, brought back to
/// the ingoing form of its metric: light that leaves the past horizon in this chart enters the future one in that. So
/// the way in towards the hole, followed into the past, is as smooth as the way out. `gradient`: maps a place to d_i r.
/// In the plane, with psi = 2 B + 2 atan(a/r), B' = a/Delta: x + i y -> conj(x + i y) exp(i psi), whence for the
/// covector k = mirrored p + (2 A' p_t + psi' L_z) grad r, k_t = -p_t. Its own inverse.
template <class T, class Gradient>
GeodesicState<T> time_reversed(const GeodesicState<T>& state, const TimeReversal<T>& by, const Gradient& gradient) {
    using std::cos, std::sin;
    const auto& [x, p] = state;
    const T c = cos(by.azimuth), s = sin(by.azimuth);
    const auto mirrored = [&](const Components<T>& a) {
        return Components<T>{-a.t, c * a.x + s * a.y, s * a.x - c * a.y, a.z};
    };
    GeodesicState<T> result{mirrored(x), mirrored(p)};
    result.position.t = by.time - x.t;
    const T along = by.time_rate * p.t + by.azimuth_rate * (x.x * p.y - x.y * p.x);
    result.momentum = result.momentum + along * gradient(result.position);
    return result;
}

/// Light that comes from far away follows l in this chart, so that what bends it there is only M b^3/(4 r^4) with b its
/// distance from the axis through the eye, at most the eye's own or, for light that went round, a few M.
inline double hole_flat_beyond(double mass, double eye_distance, double error) {
    const double b = std::max(eye_distance, 10.0 * mass);
    return std::max(std::sqrt(std::sqrt(mass * b * b * b / (4.0 * error))), 2.0 * b);
}

/// f, r and n at a place.
template <class T>
struct KerrSchildField {
    T radius;                ///< Kerr's r
    T strength;              ///< f
    Components<T> direction; ///< n; its t is unused
};

template <class T>
SymmetricTensor<T> kerr_schild_metric(const KerrSchildField<T>& field) {
    const Components<T> l{T(1.0), field.direction.x, field.direction.y, field.direction.z};
    SymmetricTensor<T> g = diagonal(T(-1.0), T(1.0), T(1.0), T(1.0));
    for (int mu = 0; mu < 4; ++mu) {
        for (int nu = mu; nu < 4; ++nu) {
            g(mu, nu) = g(mu, nu) + field.strength * l[mu] * l[nu];
        }
    }
    return g;
}

/// g^{mu nu} = eta^{mu nu} - f l^mu l^nu with l^mu = (-1, n).
template <class T>
SymmetricTensor<T> kerr_schild_inverse_metric(const KerrSchildField<T>& field) {
    const Components<T> l{T(-1.0), field.direction.x, field.direction.y, field.direction.z};
    SymmetricTensor<T> g = diagonal(T(-1.0), T(1.0), T(1.0), T(1.0));
    for (int mu = 0; mu < 4; ++mu) {
        for (int nu = mu; nu < 4; ++nu) {
            g(mu, nu) = g(mu, nu) - field.strength * l[mu] * l[nu];
        }
    }
    return g;
}

/// What all these holes are by their `mass`, `radii`, field(x) and radius(x) alone.
template <class Hole>
struct KerrSchildHole {
    static constexpr bool may_have_horizon = true;
    static constexpr bool fits_single_precision = true;

    template <class T>
    SymmetricTensor<T> metric(const Components<T>& x) const {
        return kerr_schild_metric(hole().field(x));
    }
    template <class T>
    SymmetricTensor<T> inverse_metric(const Components<T>& x) const {
        return kerr_schild_inverse_metric(hole().field(x));
    }
    template <class T>
    T step_scale(const GeodesicState<T>& state, const GeodesicState<T>& rate) const {
        return hole_step_scale(hole().mass, hole().radius(state.position), state, rate);
    }
    template <class T>
    T remoteness(const Components<T>& x) const {
        return hole().radius(x);
    }
    Region region(const Components<double>& x) const { return hole().radii.region(hole().radius(x)); }
    /// Whether time_reversed may be asked at x.
    bool reversible(const Components<double>& x) const { return hole().radii.reversible(hole().radius(x)); }
    /// Chart length beyond which light that an eye at `eye_distance` from the origin sees is bent by less than `error`
    /// (rad).
    double flat_beyond(double eye_distance = 0.0, double error = 1e-13) const {
        return hole_flat_beyond(hole().mass, eye_distance, error);
    }
    Asymptotics asymptotics(const GeodesicState<double>& state) const { return cartesian_asymptotics(state); }

  private:
    const Hole& hole() const { return static_cast<const Hole&>(*this); }
};

/// Hamilton's equations of a non-rotating hole: 2 H = eta^{ab} p_a p_b - f w^2 with w = l^a p_a = n.p - p_t, n = x/r.
template <class T>
GeodesicState<T> spherical_kerr_schild_equations(double mass, double charge, const GeodesicState<T>& state) {
    const auto& [x, p] = state;
    const T u = T(1.0) / chart_radius(x);
    const T q2(charge * charge);
    const T nx = u * x.x, ny = u * x.y, nz = u * x.z;
    const T radial = nx * p.x + ny * p.y + nz * p.z;
    const T w = radial - p.t;
    const T f = u * (T(2.0 * mass) - q2 * u);
    const T fw = f * w;
    // dp_i = 1/2 w^2 d_i f + f w d_i(n.p), with d_i f = n_i f' and d_i(n.p) = (p_i - n_i n.p)/r.
    const T along_p = fw * u;
    const T along_n = w * w * u * u * (q2 * u - T(mass)) - along_p * radial;
    return {{fw - p.t, p.x - fw * nx, p.y - fw * ny, p.z - fw * nz},
            {T(0.0), along_n * nx + along_p * p.x, along_n * ny + along_p * p.y, along_n * nz + along_p * p.z}};
}

/// Hamilton's equations of a rotating hole without charge.
template <class T>
GeodesicState<T> rotating_kerr_schild_equations(double mass, double spin, const GeodesicState<T>& state) {
    using std::sqrt;
    const auto& [x, p] = state;
    const T a(spin);
    const T a2(spin * spin);
    const T d = x.x * x.x + x.y * x.y + x.z * x.z - a2;
    const T s = sqrt(d * d + T(4.0) * a2 * x.z * x.z);
    const T r2 = T(0.5) * (d + s);
    const T r = sqrt(r2);
    const T sum = r2 + a2;
    // One division for 1/r, 1/(r^2 + a^2) and 1/S.
    const T all = T(1.0) / (r * sum * s);
    const T over_s = all * r * sum;
    const T over_r = all * sum * s;
    const T over_sum = all * r * s;
    const T two_m(2.0 * mass);
    const T f = two_m * r * over_s;
    const T nx = (r * x.x + a * x.y) * over_sum;
    const T ny = (r * x.y - a * x.x) * over_sum;
    const T nz = x.z * over_r;
    // n.p = (r A + a B)/(r^2 + a^2) + z p_z/r.
    const T outward = x.x * p.x + x.y * p.y;
    const T turning = x.y * p.x - x.x * p.y;
    const T planar = (r * outward + a * turning) * over_sum;
    const T w = planar + nz * p.z - p.t;
    const T fw = f * w;
    // d_i f = (2 M d_i r - f d_i S)/S with d_i S = 4 r d_i r - 2 x_i, and
    // d_i r = (x r, y r, z (r^2 + a^2)/r)/S. Gathered: dp_i = c_r d_i r + c_x x_i + f w (d_i n.p at fixed r).
    const T half_w2_over_s = T(0.5) * w * w * over_s;
    const T c_x = T(2.0) * half_w2_over_s * f;
    const T c_r = half_w2_over_s * (two_m - T(4.0) * r * f) +
                  fw * ((outward - T(2.0) * r * planar) * over_sum - nz * p.z * over_r);
    const T c_r_over_s = c_r * over_s;
    const T planar_factor = c_r_over_s * r + c_x;
    const T axial_factor = c_r_over_s * sum * over_r + c_x;
    const T fw_over_sum = fw * over_sum;
    return {{fw - p.t, p.x - fw * nx, p.y - fw * ny, p.z - fw * nz},
            {T(0.0), planar_factor * x.x + fw_over_sum * (r * p.x - a * p.y),
             planar_factor * x.y + fw_over_sum * (r * p.y + a * p.x), axial_factor * x.z + fw * over_r * p.z}};
}

} // namespace sim

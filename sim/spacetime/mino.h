#pragma once

#include "sim/spacetime/sky_rays.h"

#include <optional>
#include <span>

/// Light around a hole of mass M, spin a and charge e in Mino time (Mino 2003: dlambda = (r^2 + a^2 cos^2 theta) dtau),
/// which parts r from theta. With u = 1/r, N the unit vector of (theta, phi) with the dragging of space taken out, Phi
/// the angle of dragging, and L_z = lambda, Carter's Q = q for E = 1:
///   u'' = (a^2 - K) u + 3 M B u^2 - 2 (a^2 q + e^2 B) u^3,     K = q + lambda^2,   B = q + (lambda - a)^2,
///   N'' = a^2 N_z z - (K + 2 a^2 N_z^2) N,
///   Phi' = a u (2 M - e^2 u - a lambda u)/(1 - 2 M u + (a^2 + e^2) u^2).
/// No square roots, no singular axis, infinity is u = 0 at a finite tau. Followed by rk4_nystroem_step from an eye
/// outside the horizon (anywhere, without spin). Derived from the separated equations of Carter 1968 by
/// differentiation.
namespace sim {

/// A hole that the kernel knows.
struct MinoHole {
    double mass;
    double spin;
    double charge;
    HoleRadii radii;
};

/// The hole of a spacetime; nothing where it is none.
std::optional<MinoHole> mino_hole(const AnySpacetime& spacetime);

/// Whether this kernel can serve an eye there.
bool fits_mino(const MinoHole& hole, const Components<double>& event);

/// A quantity that is linear in the direction n in which an eye looks: constant + slope.n.
struct LinearInDirection {
    double constant = 0.0;
    glm::dvec3 slope{0.0};
};

/// All that the rays of one eye share.
struct MinoEye {
    MinoHole hole;
    double inverse_radius = 0.0;                 ///< u at the eye
    glm::dvec3 place{0.0};                       ///< N at the eye, azimuth as in the chart
    double azimuth = 0.0;                        ///< turn about z from N's azimuth to Boyer-Lindquist's phi
    LinearInDirection energy;                    ///< E
    LinearInDirection angular_momentum;          ///< L_z
    LinearInDirection inverse_radius_rate;       ///< E u' into the past
    std::array<LinearInDirection, 3> place_rate; ///< E N' into the past
};

/// Precondition: fits_mino.
MinoEye mino_eye(const AnySpacetime& spacetime, const MinoHole& hole, const Components<double>& event,
                 const Tetrad& tetrad);

/// y: u and N.
template <class T>
struct MinoPosition {
    T u;
    T x, y, z;

    friend MinoPosition operator+(const MinoPosition& a, const MinoPosition& b) {
        return {a.u + b.u, a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend MinoPosition operator*(const T& s, const MinoPosition& a) { return {s * a.u, s * a.x, s * a.y, s * a.z}; }
};

template <class T>
using MinoState = NystroemState<MinoPosition<T>, T>; ///< z: Phi

/// The constants of one ray (or of a lane each), E = 1.
template <class T>
struct MinoRay {
    T energy; ///< nu at infinity when the eye's is 1; not positive: it comes from the horizon
    T angular_momentum;
    T k;          ///< K
    T linear;     ///< a^2 - K
    T quadratic;  ///< 3 M B
    T cubic;      ///< -2 (a^2 q + e^2 B)
    T step_scale; ///< 1/sqrt(K + 4 M^2): a step of it turns the ray by about a radian
};

template <class T>
struct MinoStart {
    MinoRay<T> ray;
    MinoState<T> state;
};

/// The ray that the eye sees from (nx, ny, nz).
template <class T>
MinoStart<T> mino_start(const MinoEye& eye, const T& nx, const T& ny, const T& nz) {
    using std::sqrt;
    const auto at = [&](const LinearInDirection& q) {
        return T(q.constant) + T(q.slope.x) * nx + T(q.slope.y) * ny + T(q.slope.z) * nz;
    };
    const double a = eye.hole.spin;
    const double m = eye.hole.mass;
    const T energy = at(eye.energy);
    const T per_energy = T(1.0) / energy;
    const T lambda = per_energy * at(eye.angular_momentum);
    const MinoPosition<T> rate{per_energy * at(eye.inverse_radius_rate), per_energy * at(eye.place_rate[0]),
                               per_energy * at(eye.place_rate[1]), per_energy * at(eye.place_rate[2])};
    // |N'|^2 = K + a^2 N_z^2.
    const T k = rate.x * rate.x + rate.y * rate.y + rate.z * rate.z - T(a * a * eye.place.z * eye.place.z);
    const T q = k - lambda * lambda;
    const T b = k + T(a) * (T(a) - T(2.0) * lambda);
    return {{energy, lambda, k, T(a * a) - k, T(3.0 * m) * b,
             T(-2.0) * (T(a * a) * q + T(eye.hole.charge * eye.hole.charge) * b), T(1.0) / sqrt(k + T(4.0 * m * m))},
            {{T(eye.inverse_radius), T(eye.place.x), T(eye.place.y), T(eye.place.z)}, rate, T(0.0)}};
}

/// Phi', into the future.
template <class T>
T mino_dragging(const MinoHole& hole, const T& angular_momentum, const T& u) {
    const double a2e2 = hole.spin * hole.spin + hole.charge * hole.charge;
    const T two_m(2.0 * hole.mass);
    return T(hole.spin) * u * (two_m - (T(hole.charge * hole.charge) + T(hole.spin) * angular_momentum) * u) /
           (T(1.0) - u * (two_m - T(a2e2) * u));
}

/// The right-hand sides, for steps into the past: y'' is the same both ways, Phi' changes its sign. `rotating` false
/// leaves out what is zero without spin.
template <bool rotating, class T>
NystroemRate<MinoPosition<T>, T> mino_rate(const MinoHole& hole, const MinoRay<T>& ray, const MinoPosition<T>& y) {
    const T radial = y.u * (ray.linear + y.u * (ray.quadratic + y.u * ray.cubic));
    if constexpr (rotating) {
        const T along = T(hole.spin * hole.spin) * y.z;
        const T pull = -(ray.k + T(2.0) * along * y.z);
        return {{radial, pull * y.x, pull * y.y, pull * y.z + along}, -mino_dragging(hole, ray.angular_momentum, y.u)};
    } else {
        return {{radial, -ray.k * y.x, -ray.k * y.y, -ray.k * y.z}, T(0.0)};
    }
}

/// One step of tau into the past.
template <bool rotating, class T>
MinoState<T> mino_step(const MinoHole& hole, const MinoRay<T>& ray, const MinoState<T>& state, const T& step) {
    return rk4_nystroem_step(state, step, [&](const MinoPosition<T>& y) { return mino_rate<rotating>(hole, ray, y); });
}

/// Where a ray meets the plane z = 0.
struct PlaneCrossing {
    double radius = 0.0;  ///< Kerr's r
    double azimuth = 0.0; ///< Boyer-Lindquist's phi, rad
};

/// A sky ray's way through the plane z = 0, nearest to the eye first.
struct PlaneCrossings {
    static constexpr int most = 4;

    double frequency = 1.0;        ///< E = nu at infinity, the eye's being 1; not positive for captured rays only
    double angular_momentum = 0.0; ///< L_z, so that p.u = -u^t (E - Omega L_z) for a disk turning with Omega
    int count = 0;                 ///< further ones are left out
    std::array<PlaneCrossing, most> crossing{};
};

/// As trace_sky, by this kernel. `settings.step` is in its own parameter: about radians per step. `crossings` is empty
/// or as long as `rays`; those inside the orbit of light belong to it only if not settings.nothing_near_horizon.
/// Every T gives the same bits, whatever its lanes.
void trace_mino_sky(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                    std::span<SkyRay> rays, std::span<PlaneCrossings> crossings = {},
                    Precision precision = Precision::double_precision);

/// One ray at a time, without lanes: what those are measured and proved against.
void trace_mino_sky_one_by_one(const MinoEye& eye, std::span<const glm::dvec3> seen, const RaySettings& settings,
                               std::span<SkyRay> rays, std::span<PlaneCrossings> crossings = {});

} // namespace sim

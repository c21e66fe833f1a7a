#pragma once

#include "sim/four_vector.h"
#include "sim/quantities.h"
#include "sim/spin_matrix.h"

#include <glm/mat3x3.hpp>

#include <array>
#include <cmath>

/// Lorentz frames as SL(2,C) matrices (Penrose 1959; the Spin(3,1) form of Weiskopf & Hanson, SIGGRAPH 2001 course 15).
namespace sim {

/// Proper orthochronous Lorentz transformation from components in `From` to components in `To`.
template <class To, class From>
struct Lorentz {
    SpinMatrix spin;

    template <class Further>
    friend Lorentz<To, Further> operator*(const Lorentz& a, const Lorentz<From, Further>& b) {
        return {a.spin * b.spin};
    }
};

template <class To, class From>
Lorentz<From, To> inverse(const Lorentz<To, From>& a) {
    return {adjugate(a.spin)};
}

/// Pure boost: the origin of `From` moves with rapidity xi along the unit vector `along` as seen in `To`.
template <class To, class From>
Lorentz<To, From> boost(Rapidity xi, const glm::dvec3& along) {
    const double s = std::sinh(0.5 * xi.value);
    const double c = std::cosh(0.5 * xi.value);
    const SpinMatrix n = pauli(s * along, glm::dvec3(0.0));
    return {{{c + n.a.re, n.a.im}, n.b, n.c, {c + n.d.re, n.d.im}}};
}

/// Rotation by `angle` about the unit vector `axis`, right-handed.
template <class To, class From>
Lorentz<To, From> rotation(Radians angle, const glm::dvec3& axis) {
    const double s = std::sin(0.5 * angle.value);
    const double c = std::cos(0.5 * angle.value);
    const SpinMatrix n = pauli(glm::dvec3(0.0), -s * axis);
    return {{{c + n.a.re, n.a.im}, n.b, n.c, {c + n.d.re, n.d.im}}};
}

/// X' = Lambda X Lambda^dagger for X = t + x.sigma.
template <class To, class From>
FourVector<To> operator*(const Lorentz<To, From>& a, const FourVector<From>& v) {
    const SpinMatrix x{{v.t + v.space.z, 0.0}, {v.space.x, -v.space.y}, {v.space.x, v.space.y}, {v.t - v.space.z, 0.0}};
    const SpinMatrix y = a.spin * x * dagger(a.spin);
    return {0.5 * (y.a.re + y.d.re), {0.5 * (y.b.re + y.c.re), 0.5 * (y.c.im - y.b.im), 0.5 * (y.a.re - y.d.re)}};
}

/// Four-velocity of the origin of `From`, in `To`: Lambda Lambda^dagger.
template <class To, class From>
FourVector<To> four_velocity(const Lorentz<To, From>& a) {
    const SpinMatrix& m = a.spin;
    const Complex off = m.a * conj(m.c) + m.b * conj(m.d);
    const double upper = norm2(m.a) + norm2(m.b);
    const double lower = norm2(m.c) + norm2(m.d);
    return {0.5 * (upper + lower), {off.re, -off.im, 0.5 * (upper - lower)}};
}

/// The four basis vectors e_0 .. e_3 of `From` as four-vectors in `To`: e_a = Lambda sigma_a Lambda^dagger.
template <class To, class From>
std::array<FourVector<To>, 4> tetrad(const Lorentz<To, From>& a) {
    return {four_velocity(a), a * FourVector<From>{0.0, {1.0, 0.0, 0.0}}, a * FourVector<From>{0.0, {0.0, 1.0, 0.0}},
            a * FourVector<From>{0.0, {0.0, 0.0, 1.0}}};
}

/// Rapidity of the origin of `From` in `To`; exact for slow and fast frames alike (asinh of the velocity part).
template <class To, class From>
Rapidity rapidity(const Lorentz<To, From>& a) {
    const glm::dvec3 u = four_velocity(a).space;
    return Rapidity(std::asinh(std::hypot(u.x, u.y, u.z)));
}

/// Lambda = boost(xi, along) * rotation: the polar decomposition. Single-precision consumers get this (split
/// before leaving double).
struct BoostAndRotation {
    Rapidity xi;                       ///< >= 0
    glm::dvec3 along{0.0, 0.0, -1.0};  ///< unit, the eye's motion in world axes; arbitrary when xi = 0
    glm::dmat3 boosted_from_head{1.0}; ///< rotation: columns are the head's axes in the boosted frame
};

/// Splits a head frame into its pure boost and its rotation, both to a few roundings at any rapidity: nothing is
/// subtracted that grew with the boost (lorentz.cpp).
BoostAndRotation split(const Lorentz<World, Head>& world_from_head);

/// The split frame of an eye with the given velocity in the world (shorter than 1) whose axes are the world's, carried
/// over by the pure boost.
BoostAndRotation boosted_eye(const glm::dvec3& velocity);

/// What one eye ray sees of the world at rest.
struct SeenLight {
    glm::dvec3 world_direction;  ///< unit, where the light comes from in the world
    double wavelength_ratio = 1; ///< D = lambda_observed(head) / lambda_world
};

/// Aberration and Doppler of one eye ray, without trigonometry and without cancellation (half-angle form).
/// Relative error below 1e-12 in D and in the angle from the motion; only a ray so close to straight ahead that its own
/// rounding, 1e-16 radians, is more than 1e-12 of its angle from the motion has less.
SeenLight see(const BoostAndRotation& eye, const Direction<Head>& seen);
SeenLight see(const Lorentz<World, Head>& world_from_head, const Direction<Head>& seen);

/// Where an eye sees light that comes from a given direction of the world.
struct SeenFrom {
    glm::dvec3 head_direction;   ///< unit, where the light is seen coming from in the head frame
    double wavelength_ratio = 1; ///< D = lambda_observed(head) / lambda_world
};

/// The inverse of `see`.
SeenFrom where_seen(const BoostAndRotation& eye, const Direction<World>& from);

} // namespace sim

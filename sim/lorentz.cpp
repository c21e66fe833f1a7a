#include "sim/lorentz.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

/// The polar decomposition, and what a moving eye sees by the half-angle form of aberration (Penrose 1959):
/// tan(theta_world/2) = e^xi tan(theta_eye/2), D = e^-xi cos^2(theta_eye/2) + e^xi sin^2(theta_eye/2).
namespace sim {
namespace {

/// Rotation matrix of the unit quaternion w + v.
glm::dmat3 matrix_of(double w, const glm::dvec3& v) {
    glm::dmat3 matrix;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        const glm::dvec3 twice = 2.0 * glm::cross(v, axis);
        matrix[i] = axis + w * twice + glm::cross(v, twice);
    }
    return matrix;
}

/// A direction after a boost: unit vector, and the factor on the light's frequency.
struct Aberrated {
    glm::dvec3 direction;
    double frequency_ratio;
};

/// Light seen from unit direction e, looked at by an observer with tan(theta'/2) = stretch tan(theta/2) about the unit
/// vector a. With p = cos^2(theta/2) / stretch and q = stretch sin^2(theta/2) the new direction times the new
/// frequency is e_perpendicular + a (p - q), and the frequency is p + q.
Aberrated aberrate(const glm::dvec3& e, const glm::dvec3& a, double stretch) {
    // Half-angle squares from chords: 1 - cos(theta) would cancel where the boost magnifies most.
    const glm::dvec3 to_ahead = e - a;
    const glm::dvec3 to_behind = e + a;
    const double p = 0.25 * glm::dot(to_behind, to_behind) / stretch;
    const double q = 0.25 * glm::dot(to_ahead, to_ahead) * stretch;
    // The perpendicular part likewise from the shorter chord, whose rounding is small against its length.
    const glm::dvec3& chord = glm::dot(e, a) > 0.0 ? to_ahead : to_behind;
    const glm::dvec3 perpendicular = chord - a * glm::dot(chord, a);
    const glm::dvec3 direction = perpendicular + a * (p - q);
    return {direction / std::hypot(direction.x, direction.y, direction.z), p + q};
}

} // namespace

BoostAndRotation split(const Lorentz<World, Head>& world_from_head) {
    // Lambda = B R with B Hermitian and R unitary, both of determinant 1, so adj(Lambda)^dagger = B^-1 R, and
    // Lambda +- adj(Lambda)^dagger = (B +- B^-1) R = 2 cosh(xi/2) R and 2 sinh(xi/2) (n.sigma) R. The sum is a multiple
    // of a unit quaternion by its form alone, so the rotation keeps full precision at any speed.
    const SpinMatrix& m = world_from_head.spin;
    const SpinMatrix inverse_dagger = dagger(adjugate(m));
    const SpinMatrix sum = m + inverse_dagger;
    const double norm = std::hypot(std::hypot(sum.a.re, sum.a.im), std::hypot(sum.c.re, sum.c.im));
    const SpinMatrix rotation = (1.0 / norm) * sum;
    const SpinMatrix half_boost = 0.5 * ((m - inverse_dagger) * dagger(rotation));
    const glm::dvec3 sinh_half(0.5 * (half_boost.c.re + half_boost.b.re), 0.5 * (half_boost.c.im - half_boost.b.im),
                               0.5 * (half_boost.a.re - half_boost.d.re));
    const double length = std::hypot(sinh_half.x, sinh_half.y, sinh_half.z);

    BoostAndRotation result;
    result.xi = Rapidity(2.0 * std::asinh(length));
    if (length > 0.0) {
        result.along = sinh_half / length;
    }
    result.boosted_from_head = matrix_of(rotation.a.re, {-rotation.c.im, rotation.c.re, -rotation.a.im});
    return result;
}

BoostAndRotation boosted_eye(const glm::dvec3& velocity) {
    const double speed = std::hypot(velocity.x, velocity.y, velocity.z);
    BoostAndRotation eye;
    if (speed > 0.0) {
        eye.xi = Rapidity(std::atanh(speed));
        eye.along = velocity / speed;
    }
    return eye;
}

SeenLight see(const BoostAndRotation& eye, const Direction<Head>& seen) {
    const Aberrated world = aberrate(eye.boosted_from_head * seen.unit, eye.along, std::exp(eye.xi.value));
    return {world.direction, world.frequency_ratio};
}

SeenLight see(const Lorentz<World, Head>& world_from_head, const Direction<Head>& seen) {
    return see(split(world_from_head), seen);
}

SeenFrom where_seen(const BoostAndRotation& eye, const Direction<World>& from) {
    const Aberrated boosted = aberrate(from.unit, eye.along, std::exp(-eye.xi.value));
    return {glm::transpose(eye.boosted_from_head) * boosted.direction, 1.0 / boosted.frequency_ratio};
}

} // namespace sim

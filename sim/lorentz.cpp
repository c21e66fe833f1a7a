#include "sim/lorentz.h"

#include <glm/geometric.hpp>

namespace sim {
namespace {

/// The unit direction psi^dagger sigma psi / |psi|^2 that a spinor stands for.
glm::dvec3 direction_of(Complex up, Complex down, double norm) {
    const Complex cross = conj(up) * down;
    return glm::dvec3(2.0 * cross.re, 2.0 * cross.im, norm2(up) - norm2(down)) / norm;
}

} // namespace

SeenLight see(const Lorentz<World, Head>& world_from_head, const Direction<Head>& seen) {
    const glm::dvec3& n = seen.unit;
    Complex up;
    Complex down;
    if (n.z >= 0.0) {
        up = {1.0 + n.z, 0.0};
        down = {n.x, n.y};
    } else {
        up = {n.x, -n.y};
        down = {1.0 - n.z, 0.0};
    }
    const double norm_head = norm2(up) + norm2(down);
    const SpinMatrix s = dagger(adjugate(world_from_head.spin));
    const Complex world_up = s.a * up + s.b * down;
    const Complex world_down = s.c * up + s.d * down;
    const double norm_world = norm2(world_up) + norm2(world_down);
    return {direction_of(world_up, world_down, norm_world), norm_world / norm_head};
}

BoostAndRotation split(const Lorentz<World, Head>& world_from_head) {
    BoostAndRotation result;
    const FourVector<World> u = four_velocity(world_from_head);
    const double speed = std::hypot(u.space.x, u.space.y, u.space.z);
    result.xi = Rapidity(std::asinh(speed));
    if (speed > 0.0) {
        result.along = u.space / speed;
    }
    const Lorentz<World, Boosted> world_from_boosted = boost<World, Boosted>(result.xi, result.along);
    const SpinMatrix r = adjugate(world_from_boosted.spin) * world_from_head.spin;
    // Polar factor of Lambda: nearest unit quaternion to the product, so that rounding at high speed cannot skew it.
    glm::dvec4 q(0.5 * (r.a.re + r.d.re), -0.5 * (r.b.im + r.c.im), 0.5 * (r.c.re - r.b.re), 0.5 * (r.d.im - r.a.im));
    q /= glm::length(q);
    const double w = q.x;
    const glm::dvec3 v(q.y, q.z, q.w);
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        const glm::dvec3 twice = 2.0 * glm::cross(v, axis);
        result.boosted_from_head[i] = axis + w * twice + glm::cross(v, twice);
    }
    return result;
}

} // namespace sim

#pragma once

#include "sim/spacetime/geodesic.h"

#include <array>
#include <cmath>

namespace sim {

/// An orthonormal tetrad at an event: legs[a] = e_a^mu. e_0 is the four-velocity; e_1, e_2, e_3 are a camera's right,
/// up, back (it looks along -e_3).
struct Tetrad {
    std::array<Components<double>, 4> legs;
};

/// Gram and Schmidt's way from a time-like `velocity` (any length, future-directed) and two directions of the chart,
/// (x, y, z) parts of vectors: `look` is kept exactly up to the part along u, `up` up to its part along the look.
/// Precondition: the three and the chart's remaining direction are independent.
template <class Spacetime>
Tetrad camera_tetrad(const Spacetime& spacetime, const Components<double>& event, const Components<double>& velocity,
                     const glm::dvec3& look, const glm::dvec3& up) {
    const SymmetricTensor<double> g = spacetime.metric(event);
    const glm::dvec3 right(look.y * up.z - look.z * up.y, look.z * up.x - look.x * up.z, look.x * up.y - look.y * up.x);
    Tetrad tetrad;
    tetrad.legs = {
        velocity, {0.0, right.x, right.y, right.z}, {0.0, up.x, up.y, up.z}, {0.0, -look.x, -look.y, -look.z}};
    constexpr std::array order{0, 3, 2, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        Components<double>& leg = tetrad.legs[static_cast<std::size_t>(order[i])];
        // Twice, so that a leg that lies close to those before it is orthogonal to rounding all the same.
        for (int pass = 0; pass < 2; ++pass) {
            for (std::size_t j = 0; j < i; ++j) {
                const Components<double>& before = tetrad.legs[static_cast<std::size_t>(order[j])];
                const double part = contract(leg, g * before) * (j == 0 ? -1.0 : 1.0);
                leg = leg - part * before;
            }
            leg = (1.0 / std::sqrt(std::abs(contract(leg, g * leg)))) * leg;
        }
    }
    return tetrad;
}

/// The tetrad of one who moves with the velocity `beta` (right, up, back; shorter than 1) in `rest`, axes carried over
/// by the pure boost.
inline Tetrad boosted(const Tetrad& rest, const glm::dvec3& beta) {
    const double beta2 = beta.x * beta.x + beta.y * beta.y + beta.z * beta.z;
    const double gamma = 1.0 / std::sqrt(1.0 - beta2);
    const std::array<double, 3> v{beta.x, beta.y, beta.z};
    const auto moved = [&](double time, const std::array<double, 3>& along) {
        return time * rest.legs[0] + along[0] * rest.legs[1] + along[1] * rest.legs[2] + along[2] * rest.legs[3];
    };
    Tetrad tetrad;
    tetrad.legs[0] = moved(gamma, {gamma * v[0], gamma * v[1], gamma * v[2]});
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<double, 3> leg{};
        for (std::size_t j = 0; j < 3; ++j) {
            leg[j] = (i == j ? 1.0 : 0.0) + gamma * gamma / (gamma + 1.0) * v[i] * v[j];
        }
        tetrad.legs[i + 1] = moved(gamma * v[i], leg);
    }
    return tetrad;
}

/// The photon that an eye of this tetrad sees from the unit direction `seen` (right, up, back): p = e_0 - n^i e_i,
/// future-directed, frequency 1 for the eye; as a covector.
template <class Spacetime>
GeodesicState<double> seen_photon(const Spacetime& spacetime, const Components<double>& event, const Tetrad& tetrad,
                                  const glm::dvec3& seen) {
    const auto& e = tetrad.legs;
    const Components<double> p = e[0] - seen.x * e[1] - seen.y * e[2] - seen.z * e[3];
    return {event, spacetime.metric(event) * p};
}

} // namespace sim

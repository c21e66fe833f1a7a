#include "render/offline/traced/noise.h"

#include "sim/spacetime/clones.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>

namespace render {
namespace {

constexpr int corners = 8; // of a lattice cell; bits 0, 1, 2 of the number: 1 for the upper one in x, y, z
using Whole [[gnu::vector_size(corners * sizeof(std::uint64_t))]] = std::uint64_t;
using Real [[gnu::vector_size(corners * sizeof(double))]] = double;

constexpr std::array<std::uint64_t, 3> primes{0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu, 0x165667b19e3779f9u};

struct Corners {
    Real value;
};

// Values in [-1, 1] at a cell's corners, each a point of the integer lattice: the finaliser of SplitMix64 (Steele, Lea,
// Flood 2014).
Corners lattice_values(const std::array<std::int64_t, 3>& cell, std::uint64_t seed) {
    std::uint64_t base = seed;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        base += static_cast<std::uint64_t>(cell[axis]) * primes[axis];
    }
    Whole h;
    for (int corner = 0; corner < corners; ++corner) {
        const auto bits = static_cast<unsigned>(corner);
        h[corner] = base + (bits & 1u) * primes[0] + (bits >> 1u & 1u) * primes[1] + (bits >> 2u) * primes[2];
    }
    h = (h ^ (h >> 30u)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27u)) * 0x94d049bb133111ebu;
    h ^= h >> 31u;
    return {__builtin_convertvector(h >> 11u, Real) * (2.0 / 9007199254740992.0) - 1.0};
}

// A smooth value in [-1, 1] with one hump or hollow for each lattice point.
double smooth_noise(const glm::dvec3& point, std::uint64_t seed) {
    const glm::dvec3 corner = glm::floor(point);
    const glm::dvec3 t = point - corner;
    const glm::dvec3 w = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    const Corners v = lattice_values(
        {static_cast<std::int64_t>(corner.x), static_cast<std::int64_t>(corner.y), static_cast<std::int64_t>(corner.z)},
        seed);
    const auto along_x = [&](int first) { return glm::mix(v.value[first], v.value[first + 1], w.x); };
    return glm::mix(glm::mix(along_x(0), along_x(2), w.y), glm::mix(along_x(4), along_x(6), w.y), w.z);
}

} // namespace

RAPIDITY_FOR_EACH_REGISTER_WIDTH double fractal_noise(glm::dvec3 point, int octaves, std::uint64_t seed) {
    double sum = 0.0;
    double strength = 0.5;
    for (int i = 0; i < octaves; ++i) {
        sum += strength * smooth_noise(point, seed + static_cast<std::uint64_t>(i));
        point = 2.03 * point + glm::dvec3(0.37, 0.11, 0.73);
        strength *= 0.53;
    }
    return sum;
}

} // namespace render

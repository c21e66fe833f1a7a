#include "render/offline/traced/noise.h"

#include <glm/common.hpp>

#include <cmath>

namespace render {
namespace {

// A value in [-1, 1] for each point of the integer lattice: the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
double lattice_value(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
    std::uint64_t h = seed + static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u +
                      static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu +
                      static_cast<std::uint64_t>(z) * 0x165667b19e3779f9u;
    h = (h ^ (h >> 30u)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 27u)) * 0x94d049bb133111ebu;
    h ^= h >> 31u;
    return static_cast<double>(h >> 11u) * (2.0 / 9007199254740992.0) - 1.0;
}

} // namespace

double smooth_noise(const glm::dvec3& point, std::uint64_t seed) {
    const glm::dvec3 corner = glm::floor(point);
    const glm::dvec3 t = point - corner;
    const glm::dvec3 w = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    const auto x = static_cast<std::int64_t>(corner.x);
    const auto y = static_cast<std::int64_t>(corner.y);
    const auto z = static_cast<std::int64_t>(corner.z);
    const auto along_x = [&](std::int64_t j, std::int64_t k) {
        return glm::mix(lattice_value(x, y + j, z + k, seed), lattice_value(x + 1, y + j, z + k, seed), w.x);
    };
    return glm::mix(glm::mix(along_x(0, 0), along_x(1, 0), w.y), glm::mix(along_x(0, 1), along_x(1, 1), w.y), w.z);
}

double fractal_noise(glm::dvec3 point, int octaves, std::uint64_t seed) {
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

#pragma once

#include "sim/lorentz.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

/// Random frames and directions for property checks; the same ones in every run.
namespace sim_tests {

class RandomFrames {
  public:
    glm::dvec3 unit() {
        const double z = uniform(-1.0, 1.0);
        const double longitude = uniform(-std::numbers::pi, std::numbers::pi);
        const double r = std::sqrt(1.0 - z * z);
        return glm::normalize(glm::dvec3(r * std::cos(longitude), r * std::sin(longitude), z));
    }
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

    template <class To, class From>
    sim::Lorentz<To, From> frame(double rapidity) {
        return sim::boost<To, From>(sim::Rapidity(rapidity), unit()) *
               sim::rotation<From, From>(sim::Radians(uniform(0.0, 6.28)), unit());
    }

  private:
    std::mt19937_64 engine_{20260101};
};

/// Directions over the whole sky; other ones for another seed.
inline std::vector<glm::dvec3> random_directions(unsigned seed, int count) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> result;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 v(normal(random), normal(random), normal(random));
        result.push_back(v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
    }
    return result;
}

} // namespace sim_tests

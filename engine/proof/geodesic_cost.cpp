#include "engine/proof/geodesic_cost.h"

#include "engine/median.h"
#include "sim/spacetime/geodesic.h"
#include "sim/spacetime/kerr.h"
#include "sim/spacetime/schwarzschild.h"

#include <cmath>
#include <ctime>
#include <limits>
#include <type_traits>

namespace engine {
namespace {

/// A ray that passes a hole of mass 1: from (30, 6, 1) inwards, with p_t such that H = 0.
template <class Spacetime>
sim::GeodesicState<double> passing_ray(const Spacetime& spacetime) {
    sim::GeodesicState<double> ray{{0.0, 30.0, 6.0, 1.0}, {0.0, -1.0, 0.0, 0.0}};
    const auto g = spacetime.inverse_metric(ray.position);
    double mixed = 0.0;
    double spatial = 0.0;
    for (int i = 1; i < 4; ++i) {
        mixed += g(0, i) * ray.momentum[i];
        for (int j = 1; j < 4; ++j) {
            spatial += g(i, j) * ray.momentum[i] * ray.momentum[j];
        }
    }
    // g^tt p_t^2 + 2 mixed p_t + spatial = 0; the root of a photon that goes into the future has p_t < 0.
    ray.momentum.t = (-mixed + std::sqrt(mixed * mixed - g(0, 0) * spatial)) / g(0, 0);
    return ray;
}

template <class Spacetime>
double nanoseconds_a_step(const Spacetime& spacetime) {
    // Straight code: nothing here has a table of virtual functions or owns memory.
    static_assert(!std::is_polymorphic_v<Spacetime> && std::is_trivially_copyable_v<Spacetime>);
    static_assert(std::is_trivially_copyable_v<sim::GeodesicState<double>>);
    constexpr int rays = 100;
    constexpr int steps = 100;
    const sim::GeodesicState<double> start = passing_ray(spacetime);
    double read = 0.0;
    const std::clock_t before = std::clock();
    for (int ray = 0; ray < rays; ++ray) {
        sim::GeodesicState<double> state = start;
        for (int i = 0; i < steps; ++i) {
            state = sim::geodesic_step(spacetime, state, 0.05);
        }
        read += state.position.x;
    }
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    return std::isfinite(read) ? seconds / (rays * steps) * 1e9 : std::numeric_limits<double>::infinity();
}

} // namespace

std::vector<GeodesicCost> geodesic_costs(int rounds) {
    const sim::Schwarzschild schwarzschild(1.0);
    const sim::Kerr kerr(1.0, 0.9);
    std::vector<double> of_schwarzschild;
    std::vector<double> of_kerr;
    for (int round = 0; round < rounds; ++round) {
        of_schwarzschild.push_back(nanoseconds_a_step(schwarzschild));
        of_kerr.push_back(nanoseconds_a_step(kerr));
    }
    return {{"Schwarzschild", median(of_schwarzschild)}, {"Kerr, spin 0.9", median(of_kerr)}};
}

} // namespace engine

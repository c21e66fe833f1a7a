#include "sim/lorentz.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using Catch::Matchers::WithinRel;

TEST_CASE("a boost along z gives the hyperbolic four-velocity") {
    const auto frame = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(1.5), {0.0, 0.0, 1.0});
    const auto u = sim::four_velocity(frame);
    // A few roundings of numbers near cosh 1.5.
    CHECK_THAT(u.t, WithinRel(std::cosh(1.5), 1e-15));
    CHECK_THAT(u.space.z, WithinRel(std::sinh(1.5), 1e-15));
}

#include "engine/hud/notices.h"
#include "engine/hud/readouts.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

namespace {

/// Instruments of a ship at rapidity xi along the nose.
sim::Readings at_rapidity(double xi) {
    sim::VehicleState state;
    state.world_from_vehicle = sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(xi), {0.0, 0.0, -1.0});
    return sim::readings(state);
}

} // namespace

TEST_CASE("speed shows as many nines as it has, and never reads 1") {
    CHECK(engine::beta_text(at_rapidity(0.0)) == "0.0000");
    CHECK(engine::beta_text(at_rapidity(std::atanh(0.5))) == "0.5000");
    CHECK(engine::beta_text(at_rapidity(std::atanh(0.99))) == "0.9900");
    CHECK(engine::beta_text(at_rapidity(std::atanh(0.99995))) == "0.999950");
    // 1 - beta = 2 / (e^20 + 1) = 4.122e-9 and, for 20, 2 / (e^40 + 1) = 8.5e-18: below the last bit of a double.
    CHECK(engine::beta_text(at_rapidity(10.0)) == "0.9999999958");
    CHECK(engine::beta_text(at_rapidity(20.0)) == "1 - 8.5e-18");
}

TEST_CASE("gamma shows how little it is above 1 near rest, and powers of ten far out") {
    CHECK(engine::gamma_text(at_rapidity(0.0)) == "1.000");
    CHECK(engine::gamma_text(at_rapidity(0.01)) == "1 + 5.0e-05");
    CHECK(engine::gamma_text(at_rapidity(std::atanh(0.6))) == "1.250");
    CHECK(engine::gamma_text(at_rapidity(20.0)) == "2.43e+08");
}

TEST_CASE("clocks, wavelength ratio and felt acceleration") {
    CHECK(engine::clock_text(12.345, "s") == "12.35 s");
    CHECK(engine::clock_text(1.0345, "yr") == "1.0345 yr");
    CHECK(engine::clock_text(1234.56, "s") == "1234.6 s");
    CHECK(engine::clock_text(2.5e7, "s") == "2.5000e+07 s");
    CHECK(engine::wavelength_ratio_text(0.1421) == "0.142");
    CHECK(engine::wavelength_ratio_text(7.0888) == "7.09");
    CHECK(engine::wavelength_ratio_text(0.0000454) == "4.5e-05");
    // One g is 1.032 c per year: the trip through the stars.
    const double year = 31557600.0;
    CHECK(engine::g_from_acceleration(1.0, 299792458.0, year) == Catch::Approx(0.96872).epsilon(1e-5));
    CHECK(engine::g_text(0.96872) == "0.969 g");
    CHECK(engine::g_text(0.0) == "0 g");
}

TEST_CASE("a notice leaves in time, and saying it again keeps it") {
    engine::Notices notices;
    notices.show("one", 2.0);
    notices.show("two", 1.0);
    notices.advance(0.75);
    notices.show("two", 1.0);
    notices.advance(0.75);
    CHECK(notices.lines() == std::vector<std::string>{"one", "two"});
    notices.advance(0.75);
    CHECK(notices.lines().empty());
}

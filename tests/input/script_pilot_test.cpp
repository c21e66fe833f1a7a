#include "input/script_pilot.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("a script's segments last whole ticks that do not drift") {
    // Thirds of a tick: the boundaries fall at round(10/3), round(20/3), 10.
    const sim::FlightScript script(3, {sim::ProperTime(1.0 / 3.0), {1.0, 0.0, 0.0}, {}});
    input::ScriptPilot pilot(script, 10.0);
    for (sim::Tick tick = 0; tick < 10; ++tick) {
        CHECK(pilot.control(tick).has_value());
    }
    CHECK_FALSE(pilot.control(10).has_value());
}

#include "input/replay_pilot.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("a replayed demand holds from its tick until the next one's") {
    sim::ControlFrame ahead;
    ahead.proper_acceleration.z = -1.0;
    sim::ControlFrame brake;
    brake.buttons = sim::ControlFrame::brake;
    input::ReplayPilot pilot({{2, ahead}, {5, brake}}, 7);
    for (sim::Tick tick = 0; tick < 7; ++tick) {
        const sim::ControlFrame expected = tick < 2 ? sim::ControlFrame() : tick < 5 ? ahead : brake;
        CHECK(pilot.control(tick) == expected);
    }
    CHECK_FALSE(pilot.control(7).has_value());
}

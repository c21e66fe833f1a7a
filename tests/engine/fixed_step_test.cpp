#include "engine/fixed_step.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <numeric>
#include <vector>

using engine::FixedStep;

namespace {

/// Ticks flown over a list of frame times, in seconds.
std::vector<sim::Tick> ticks_of(FixedStep& clock, const std::vector<double>& frame_seconds) {
    std::vector<sim::Tick> ticks;
    for (const double seconds : frame_seconds) {
        ticks.push_back(clock.advance(seconds).ticks);
    }
    return ticks;
}

} // namespace

// All times below are multiples of powers of two, so that sums of them are exact.

TEST_CASE("whole ticks come out and the remainder is kept") {
    FixedStep clock(8.0);
    CHECK(ticks_of(clock, {0.125, 0.0625, 0.0625, 0.1875, 0.0}) == std::vector<sim::Tick>{1, 0, 1, 1, 0});
    CHECK(clock.advance(0.0).fraction == 0.5);
}

TEST_CASE("the same time cut differently flies the same ticks") {
    FixedStep coarse(256.0);
    FixedStep fine(256.0);
    const auto few = ticks_of(coarse, std::vector<double>(8, 0.125));
    const auto many = ticks_of(fine, std::vector<double>(1024, 0.0009765625));
    CHECK(std::accumulate(few.begin(), few.end(), sim::Tick{0}) == 256);
    CHECK(std::accumulate(many.begin(), many.end(), sim::Tick{0}) == 256);
}

TEST_CASE("a slow frame drops time and says how much") {
    FixedStep clock(240.0, 0.25);
    const FixedStep::Steps slow = clock.advance(3.0);
    CHECK(slow.ticks == 60);
    CHECK(slow.dropped_seconds == 2.75);
    const FixedStep::Steps next = clock.advance(0.25);
    CHECK(next.ticks == 60);
    CHECK(next.dropped_seconds == 0.0);
}

TEST_CASE("a clock that runs backwards counts as standing still") {
    FixedStep clock(240.0);
    const FixedStep::Steps steps = clock.advance(-1.0);
    CHECK(steps.ticks == 0);
    CHECK(steps.dropped_seconds == 0.0);
}

TEST_CASE("pace makes slow and fast motion") {
    FixedStep clock(64.0);
    clock.set_pace(0.25);
    CHECK(ticks_of(clock, {0.0625, 0.0625}) == std::vector<sim::Tick>{1, 1});
    clock.set_pace(4.0);
    CHECK(ticks_of(clock, {0.0625}) == std::vector<sim::Tick>{16});
}

TEST_CASE("a year as the clock unit: pictures move between the rare ticks") {
    FixedStep clock(240.0);
    clock.set_pace(1.0 / 1024.0);
    const FixedStep::Steps first = clock.advance(0.03125);
    const FixedStep::Steps second = clock.advance(0.03125);
    CHECK(first.ticks == 0);
    CHECK(first.fraction > 0.0);
    CHECK(second.fraction == 2.0 * first.fraction);
}

TEST_CASE("paused, only the requested single ticks pass, and the picture advances by exactly one tick") {
    FixedStep clock(8.0);
    const double fraction = clock.advance(0.0625).fraction;
    clock.set_paused(true);
    CHECK(ticks_of(clock, {10.0, 0.125}) == std::vector<sim::Tick>{0, 0});
    clock.request_single_tick();
    const FixedStep::Steps single = clock.advance(0.125);
    CHECK(single.ticks == 1);
    CHECK(single.fraction == fraction);
    CHECK(clock.advance(0.125).ticks == 0);
    clock.set_paused(false);
    CHECK(clock.advance(0.0625).ticks == 1);
}

TEST_CASE("a single tick asked for while flying is not saved up") {
    FixedStep clock(8.0);
    clock.request_single_tick();
    CHECK(clock.advance(0.0).ticks == 0);
    clock.set_paused(true);
    CHECK(clock.advance(0.0).ticks == 0);
}

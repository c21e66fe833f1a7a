#include "engine/replay_deck.h"

#include "engine/flight_table.h"
#include "engine/recording_diff.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "engine/replay_timeline.h"
#include "recorded_flight.h"
#include "sim/bad_input.h"
#include "sim/readings.h"
#include "sim/state_hash.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr sim::Tick ticks = 2000;

/// A recorded flight with a change in its middle, and the state after every tick of it.
struct Flown {
    Flown() {
        recorded_flight::record(folder / "a.rapidity", ticks);
        recording = engine::read_sound_recording(folder / "a.rapidity");
        engine::fly_again(recording, [this](const sim::VehicleState& state) { states.push_back(state); });
        // The visitor hears of a tick before the change that follows it.
        states.at(ticks / 2) = recording.changes.at(1).state;
    }
    recorded_flight::Folder folder;
    engine::Recording recording;
    std::vector<sim::VehicleState> states;
};

bool stands_at(const engine::ReplayDeck& deck, const Flown& flown, sim::Tick tick) {
    return deck.position() == static_cast<double>(tick) &&
           sim::state_hash(deck.state()) == sim::state_hash(flown.states.at(tick));
}

} // namespace

TEST_CASE("a replay goes to any tick, in any order, bit for bit") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    CHECK(stands_at(deck, flown, 0));
    std::mt19937 random(1);
    std::uniform_int_distribution<sim::Tick> any(0, ticks);
    for (int i = 0; i < 200; ++i) {
        const sim::Tick tick = any(random);
        deck.seek(static_cast<double>(tick));
        REQUIRE(stands_at(deck, flown, tick));
        REQUIRE(deck.moment().vehicle.maximum_acceleration.x ==
                (tick < ticks / 2 ? 0.5 : 0.25)); // the change halves it
    }
    deck.seek(1e300);
    CHECK(stands_at(deck, flown, ticks));
    deck.seek(-1.0);
    CHECK(stands_at(deck, flown, 0));
}

TEST_CASE("a replay steps both ways, through snapshots and changes") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    deck.seek(1250.0);
    for (sim::Tick tick = 1249; tick > 700; --tick) {
        deck.step(-1);
        REQUIRE(stands_at(deck, flown, tick));
    }
    for (sim::Tick tick = 702; tick < 1250; ++tick) {
        deck.step(1);
        REQUIRE(stands_at(deck, flown, tick));
    }
    deck.seek(100.5); // between two ticks a step goes to the one before or after
    deck.step(-1);
    CHECK(stands_at(deck, flown, 100));
    deck.seek(100.5);
    deck.step(1);
    CHECK(stands_at(deck, flown, 101));
}

TEST_CASE("a replay plays at its speed, backwards too, and stops at its ends") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    CHECK(deck.speed() == 1.0);
    deck.advance(2.0); // at 240 ticks a second
    CHECK(stands_at(deck, flown, 480));
    for (int i = 0; i < 30; ++i) {
        deck.slower();
    }
    CHECK(deck.speed() == 0.01);
    deck.advance(1.0);
    CHECK_THAT(deck.position(), WithinAbs(482.4, 1e-9)); // a rounding of 0.01 * 240
    for (int i = 0; i < 30; ++i) {
        deck.faster();
    }
    CHECK(deck.speed() == 1000.0);
    deck.advance(1.0);
    CHECK(stands_at(deck, flown, ticks));
    CHECK(deck.paused());
    deck.advance(1.0);
    CHECK(stands_at(deck, flown, ticks));
    deck.reverse();
    deck.set_paused(false);
    deck.advance(0.005); // 1200 ticks
    CHECK(stands_at(deck, flown, 800));
    deck.advance(1.0);
    CHECK(stands_at(deck, flown, 0));
    CHECK(deck.paused());
}

TEST_CASE("between two ticks a replay shows the ship on its way") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    for (const double fraction : {0.25, 0.5, 0.999}) {
        deck.seek(1300.0 + fraction);
        const sim::VehicleState state = deck.state();
        const sim::VehicleState& before = flown.states[1300];
        CHECK(state.tick == 1301);
        // One rounding of each sum: clocks of a few units.
        CHECK_THAT(state.ship_clock.value, WithinAbs(before.ship_clock.value + fraction / 240.0, 1e-14));
        CHECK(state.event.t > before.event.t);
        CHECK(state.event.t < flown.states[1301].event.t);
    }
}

TEST_CASE("marks are the flight's start, changes and end, and a replay goes from one to the next") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    deck.set_paused(true);
    REQUIRE(deck.marks().size() == 3);
    deck.seek_mark(true);
    CHECK(stands_at(deck, flown, ticks / 2));
    deck.seek(300.0);
    CHECK(deck.mark().what == "bookmark: 1");
    deck.seek_mark(true);
    CHECK(stands_at(deck, flown, ticks / 2));
    deck.seek_mark(false);
    CHECK(stands_at(deck, flown, 300));
    deck.seek_mark(false);
    CHECK(stands_at(deck, flown, 0));
    deck.seek_mark(false);
    CHECK(stands_at(deck, flown, 0));
}

TEST_CASE("a branch begins bit for bit where the replay stands, and says where that is") {
    const Flown flown;
    engine::ReplayDeck deck(flown.recording);
    deck.seek(777.7);
    const engine::FlightChange start = deck.branch();
    CHECK(sim::state_hash(start.state) == sim::state_hash(flown.states[777]));
    engine::RecordingHeader header = flown.recording.header;
    header.origin = deck.branch_origin();
    {
        engine::Recorder recorder(flown.folder / "branch.rapidity", header, start);
        recorded_flight::Flight flight(recorder, start);
        flight.fly(700);
    }
    const engine::Recording branch = engine::read_sound_recording(flown.folder / "branch.rapidity");
    CHECK(branch.first_tick() == 777);
    CHECK(branch.end() == 1477);
    CHECK(branch.header.origin.find("branch of a.rapidity at tick 777") == 0);
    CHECK(engine::fly_again(branch).ticks == 700);
    engine::ReplayDeck again(branch);
    CHECK(sim::state_hash(again.state()) == sim::state_hash(flown.states[777]));
}

TEST_CASE("two recordings part where their demands do") {
    const Flown flown;
    CHECK(engine::difference(flown.recording, flown.recording).same());
    engine::Recording other = flown.recording;
    sim::Tick parted = 0;
    for (input::TimedControl& timed : other.controls) {
        if (timed.tick >= 1300) {
            timed.control.angular_velocity.x += 0.25;
            parted = timed.tick;
            break;
        }
    }
    other.snapshots.clear(); // they belong to the flight as it was
    const engine::RecordingDifference found = engine::difference(flown.recording, other);
    CHECK(found.demands_part == parted);
    CHECK(found.states_part == parted + 1);
    CHECK_FALSE(found.fields.empty());
    for (const std::string& field : found.fields) { // a pure number has no unit, and any other has its own
        INFO(field);
        CHECK(field.ends_with("rad/clock unit)") == field.starts_with("angular_velocity"));
        CHECK_FALSE(field.ends_with(" 1)"));
    }
    CHECK(found.separation > 0.0);
    CHECK(found.relative_rapidity.value > 0.0);
}

TEST_CASE("a timeline has the flight's start and end, and ticks evenly between them") {
    const Flown flown;
    const std::vector<engine::TimelinePoint> all = engine::timeline(flown.recording, 10 * ticks);
    REQUIRE(all.size() == ticks + 1);
    for (const sim::Tick tick : {sim::Tick{0}, sim::Tick{7}, sim::Tick{719}, ticks / 2, ticks}) {
        CHECK(all[tick].tick == tick);
        CHECK(all[tick].beta == sim::readings(flown.states[tick]).beta);
        CHECK(all[tick].thrust == sim::readings(flown.states[tick]).felt_acceleration);
    }
    const std::vector<engine::TimelinePoint> few = engine::timeline(flown.recording, 5);
    REQUIRE(few.size() == 5);
    CHECK(few[3].tick == 3 * ticks / 4);
    CHECK(few.back().tick == ticks);
}

TEST_CASE("tables have any columns at any rate, in CSV and JSON alike") {
    const Flown flown;
    const std::vector<std::string> columns{"tick", "u_t", "gamma", "demanded_turn_rate_x", "start_clock_seen"};
    engine::write_flight_table(flown.recording, {columns, 2.5, engine::TableFormat::csv}, flown.folder / "a.csv");
    std::ifstream csv(flown.folder / "a.csv");
    std::string line;
    std::getline(csv, line);
    CHECK(line == "tick [1],u_t [1],gamma [1],demanded_turn_rate_x [rad/clock unit],start_clock_seen [clock unit]");
    int rows = 0;
    while (std::getline(csv, line)) {
        double tick = 0.0;
        double energy = 0.0;
        double gamma = 0.0;
        REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf", &tick, &energy, &gamma) == 3);
        CHECK(tick == 2.5 * rows);
        CHECK_THAT(energy, WithinRel(gamma, 1e-14)); // two ways to the same number
        ++rows;
    }
    CHECK(rows == 801); // 2000 / 2.5 and the end
    engine::write_flight_table(flown.recording, {columns, 1000.0, engine::TableFormat::json}, flown.folder / "a.json");
    std::ifstream json(flown.folder / "a.json");
    const std::string text{std::istreambuf_iterator<char>(json), std::istreambuf_iterator<char>()};
    CHECK(text.find(R"({"name": "u_t", "unit": "1", "meaning": "four-velocity in the world"})") != std::string::npos);
    CHECK(text.find("[1000, ") != std::string::npos);
    CHECK_THROWS_AS(engine::write_flight_table(flown.recording, {{"speeed"}, 1.0, {}}, flown.folder / "b.csv"),
                    sim::BadInput);
}

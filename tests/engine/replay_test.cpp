#include "content/csv.h"
#include "engine/flight.h"
#include "engine/flight_table.h"
#include "engine/recorder.h"
#include "engine/recording_file.h"
#include "engine/replay.h"
#include "engine/replay_check.h"
#include "engine/replay_deck.h"
#include "recorded_flight.h"
#include "sim/bad_input.h"
#include "sim/state_hash.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>

namespace {

/// Flies as the restless hand does, without end.
class RestlessPilot final : public input::Pilot {
  public:
    std::optional<sim::ControlFrame> control(sim::Tick /*tick*/) override { return hand_.next(); }

  private:
    recorded_flight::RestlessHand hand_;
};

void fly(engine::Flight& flight, input::Pilot& pilot, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        flight.tick(pilot);
    }
}

} // namespace

TEST_CASE("a replay of a recording shows the recorded flight, changes on the way included") {
    const recorded_flight::Folder folder;
    content::Scenario place = recorded_flight::scenario();
    place.start_beta = 0.4;
    const engine::FlightChange start{"start", engine::starting_state(place), place.vehicle,
                                     place.metres_per_light_unit()};
    auto recorder = std::make_unique<engine::Recorder>(folder / "a.rapidity", engine::describe_flight(place), start);
    engine::Recorder& sink = *recorder;
    engine::Flight flown(place, std::move(recorder));
    RestlessPilot hand;
    fly(flown, hand, 300);
    flown.set_speed_of_light(1000.0);
    fly(flown, hand, 7);
    sim::VehicleSettings weaker = flown.vehicle();
    weaker.maximum_acceleration *= 0.25;
    flown.set_vehicle(weaker, "maximum acceleration");
    flown.set_speed_of_light(2000.0); // two changes at one tick
    fly(flown, hand, 400);
    sink.close();
    REQUIRE(sink.trouble().empty());

    const engine::Recording recording = engine::read_sound_recording(folder / "a.rapidity");
    CHECK(engine::fly_again(recording).ticks == 707);

    engine::ReplayDeck shown(recording);
    CHECK(shown.state().event == start.state.event);
    shown.seek(707.0);
    CHECK(sim::state_hash(shown.state()) == sim::state_hash(flown.state()));
    CHECK(shown.moment().metres_per_light_unit == flown.metres_per_light_unit());
    CHECK(shown.moment().vehicle.maximum_acceleration == weaker.maximum_acceleration);
}

TEST_CASE("a replay takes the place from the scenario's file and the flight from the recording") {
    const recorded_flight::Folder folder;
    std::ofstream(folder / "place.toml") << "title = \"A place\"\n";
    const content::Scenario place = content::load_scenario((folder / "place.toml").string());
    engine::FlightChange start{"start", engine::starting_state(place), place.vehicle, 1234.5};
    start.vehicle.maximum_acceleration.x = 0.125; // weaker and slower light than the file says
    engine::Recorder(folder / "a.rapidity", engine::describe_flight(place), start);

    const engine::Replay replay = engine::load_replay(folder / "a.rapidity");
    CHECK(replay.scenario.title == "A place");
    CHECK(replay.scenario.vehicle.maximum_acceleration.x == 0.125);
    CHECK(replay.scenario.metres_per_light_unit() == 1234.5);
    CHECK(replay.warnings.empty());

    std::ofstream(folder / "place.toml", std::ios::app) << "# moved a lamp\n";
    CHECK(engine::load_replay(folder / "a.rapidity").warnings.size() == 1);
    std::filesystem::remove(folder / "place.toml");
    CHECK_THROWS_AS(engine::load_replay(folder / "a.rapidity"), sim::BadInput);
}

TEST_CASE("a flight's table has its units in the header and the snapshots' numbers in its rows") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 500);
    const engine::Recording recording = engine::read_sound_recording(folder / "a.rapidity");
    engine::write_flight_table(recording, {}, folder / "a.csv");

    const content::CsvTable table = content::read_csv(folder / "a.csv");
    REQUIRE(table.rows.size() == 4); // start, 240, 480, end
    const std::size_t tick = table.column("tick [1]");
    CHECK(table.number(0, tick) == 0.0);
    CHECK(table.number(3, tick) == 500.0);
    CHECK(table.number(1, table.column("event_x [light clock unit]")) == recording.snapshots[0].event.space.x);
    CHECK(table.number(2, table.column("spin_c_im [1]")) == recording.snapshots[1].world_from_vehicle.spin.c.im);
    CHECK(table.number(2, table.column("beta [1]")) < 1.0);
    CHECK_THROWS_AS(engine::write_flight_table(recording, {}, folder / "no/such/folder.csv"), sim::BadInput);
}

namespace {

/// Thrusts, and turns by a step of 30 degrees now and then.
class SnappingPilot final : public input::Pilot {
  public:
    std::optional<sim::ControlFrame> control(sim::Tick tick) override {
        sim::ControlFrame control;
        control.proper_acceleration = {0.0, 0.0, -1.0};
        if (tick % 37 == 5) {
            control.angular_velocity = {0.0, std::numbers::pi / 6.0 * 240.0, 0.0};
            control.buttons = sim::ControlFrame::snap_turn;
        }
        return control;
    }
};

} // namespace

TEST_CASE("snap turns are recorded, fly again bit for bit, and show at once") {
    const recorded_flight::Folder folder;
    const content::Scenario place = recorded_flight::scenario();
    const engine::FlightChange start{"start", engine::starting_state(place), place.vehicle,
                                     place.metres_per_light_unit()};
    auto recorder = std::make_unique<engine::Recorder>(folder / "a.rapidity", engine::describe_flight(place), start);
    engine::Recorder& sink = *recorder;
    engine::Flight flown(place, std::move(recorder));
    SnappingPilot pilot;
    fly(flown, pilot, 6);
    // The turn is there from the start of its tick on, and is not drawn out over it.
    const auto ahead = [&](double fraction) {
        return sim::split({flown.between(fraction).world_from_vehicle.spin}).boosted_from_head[2];
    };
    CHECK(glm::dot(ahead(0.0), ahead(1e-9)) < std::cos(std::numbers::pi / 6.0) + 1e-6);
    CHECK(glm::dot(ahead(1e-9), ahead(1.0)) > 1.0 - 1e-6);
    fly(flown, pilot, 300);
    const std::uint64_t hash = sim::state_hash(flown.state());
    sink.close();
    const engine::Recording recording = engine::read_sound_recording(folder / "a.rapidity");
    CHECK(engine::fly_again(recording).ticks == 306);
    engine::Flight again(place, nullptr);
    fly(again, pilot, 306);
    CHECK(sim::state_hash(again.state()) == hash);
}

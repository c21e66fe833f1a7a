#include "engine/recorder.h"

#include "engine/failure.h"
#include "engine/flight_file.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "recorded_flight.h"
#include "sim/bad_input.h"
#include "sim/snapshot.h"
#include "sim/state_hash.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <stdlib.h> // setenv is POSIX's, not <cstdlib>'s
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

/// Keeps everything that it hears.
class Witness final : public engine::TickSink {
  public:
    void on_tick(const sim::ControlFrame& control, const sim::VehicleState& after) override {
        controls.push_back(control);
        states.push_back(after);
    }
    void on_event(const sim::FlightEvent& event) override { events.push_back(event); }
    void on_change(const engine::FlightChange& change) override { changes.push_back(change); }
    std::string trouble() const override { return ""; }

    std::vector<sim::ControlFrame> controls;
    std::vector<sim::VehicleState> states;
    std::vector<engine::FlightChange> changes;
    std::vector<sim::FlightEvent> events;
};

} // namespace

TEST_CASE("a recording gives back every demand, change and snapshot, bit for bit") {
    const recorded_flight::Folder folder;
    const content::Scenario place = recorded_flight::scenario();
    constexpr sim::Tick ticks = 2000;
    recorded_flight::record(folder / "a.rapidity", ticks);

    // The same repeatable flight once more, into memory.
    Witness witness;
    recorded_flight::Flight flight(witness, recorded_flight::start(place));
    flight.fly(ticks / 2);
    flight.change();
    flight.fly(ticks - ticks / 2);

    const engine::Recording recording = engine::read_sound_recording(folder / "a.rapidity");
    CHECK(recording.header.title == place.title);
    REQUIRE(recording.ending == ticks);
    input::ReplayPilot pilot(recording.controls, recording.end());
    for (sim::Tick tick = 0; tick < ticks; ++tick) {
        const sim::ControlFrame& flown = witness.controls[tick];
        const std::optional<sim::ControlFrame> recorded = pilot.control(tick);
        REQUIRE(recorded == flown);
        REQUIRE(std::signbit(recorded->angular_velocity.z) == std::signbit(flown.angular_velocity.z));
    }
    CHECK_FALSE(pilot.control(ticks));

    REQUIRE(recording.snapshots.size() == ticks / 240);
    for (const sim::VehicleState& snapshot : recording.snapshots) {
        REQUIRE(sim::snapshot(snapshot) == sim::snapshot(witness.states[snapshot.tick - 1]));
    }
    REQUIRE(recording.changes.size() == 2);
    CHECK(recording.changes[1].state.tick == ticks / 2);
    CHECK(recording.changes[1].what == witness.changes[0].what);
    CHECK(recording.changes[1].vehicle.maximum_acceleration == witness.changes[0].vehicle.maximum_acceleration);
    CHECK(recording.changes[1].metres_per_light_unit == witness.changes[0].metres_per_light_unit);
}

TEST_CASE("a recorded flight flown again is the same flight") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 2000);
    const engine::ReplayReport report = engine::fly_again(engine::read_recording(folder / "a.rapidity"));
    CHECK(report.ticks == 2000);
    CHECK(report.hashes >= 2000 / 240 + 1); // every snapshot, and the heartbeats
}

TEST_CASE("a flight goes on from any recorded snapshot to the same end") {
    const recorded_flight::Folder folder;
    const sim::VehicleState last = recorded_flight::record(folder / "a.rapidity", 2000);
    const engine::Recording recording = engine::read_sound_recording(folder / "a.rapidity");
    for (const sim::VehicleState& snapshot : recording.snapshots) {
        if (snapshot.tick < recording.changes.back().state.tick) {
            continue;
        }
        input::ReplayPilot pilot(recording.controls, recording.end());
        sim::VehicleState state = snapshot;
        while (const auto control = pilot.control(state.tick)) {
            state = sim::advance(state, recording.changes.back().vehicle, *control);
        }
        CHECK(sim::state_hash(state) == sim::state_hash(last));
    }
}

TEST_CASE("a flight without a single tick is a recording too") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "a.rapidity", 0);
    CHECK(engine::fly_again(engine::read_recording(folder / "a.rapidity")).ticks == 0);
}

TEST_CASE("a recording never overwrites a file") {
    const recorded_flight::Folder folder;
    std::ofstream(folder / "a.rapidity") << "a diary";
    CHECK_THROWS_AS(recorded_flight::record(folder / "a.rapidity", 10), sim::BadInput);
    std::string kept;
    std::getline(std::ifstream(folder / "a.rapidity"), kept);
    CHECK(kept == "a diary");
}

TEST_CASE("flights get names of their own in the chosen folder") {
    const recorded_flight::Folder folder;
    REQUIRE(setenv("RAPIDITY_FLIGHTS_DIR", (folder / "new/flights").c_str(), 1) == 0);
    const auto first = engine::new_flight_file("../lattice");
    const auto second = engine::new_flight_file("../lattice");
    REQUIRE(unsetenv("RAPIDITY_FLIGHTS_DIR") == 0);
    CHECK(first != second);
    CHECK(first.parent_path() == folder / "new/flights");
    CHECK(first.extension() == ".rapidity");
    CHECK(std::filesystem::exists(first));
}

TEST_CASE("a file that cannot be created leaves the flight alone and says so") {
    const recorded_flight::Folder folder;
    std::ofstream(folder / "file") << "no folder";
    const content::Scenario place = recorded_flight::scenario();
    const auto file = folder / "file/a.rapidity"; // root may write to any folder, but not into a file
    engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place));
    recorded_flight::Flight flight(recorder, recorded_flight::start(place));
    flight.fly(1000);
    CHECK(flight.state().tick == 1000);
    CHECK_THAT(recorder.trouble(), ContainsSubstring("cannot be opened or written"));
}

namespace {

/// While it lives, this process is not root, who may write anywhere.
class Nobody {
  public:
    Nobody() {
        constexpr uid_t nobody = 65534;
        changed_ = geteuid() == 0 && seteuid(nobody) == 0;
    }
    ~Nobody() {
        if (changed_ && seteuid(0) != 0) {
            std::abort(); // the tests behind this one need root back
        }
    }
    Nobody(const Nobody&) = delete;
    Nobody& operator=(const Nobody&) = delete;

  private:
    bool changed_ = false;
};

} // namespace

TEST_CASE("in a folder that is read-only the flight goes on, and the recording that cannot be is told of") {
    const recorded_flight::Folder folder;
    recorded_flight::record(folder / "whole.rapidity", 300);
    const auto mode = [&folder](std::filesystem::perms perms) { std::filesystem::permissions(folder.path(), perms); };
    mode(static_cast<std::filesystem::perms>(0555));
    {
        const Nobody nobody;
        REQUIRE_FALSE(std::ofstream(folder / "probe").is_open()); // it is read-only indeed
        const content::Scenario place = recorded_flight::scenario();
        engine::Recorder recorder(folder / "a.rapidity", engine::describe_flight(place), recorded_flight::start(place));
        recorded_flight::Flight flight(recorder, recorded_flight::start(place));
        flight.fly(1000);
        CHECK(flight.state().tick == 1000);
        CHECK_THAT(recorder.trouble(), ContainsSubstring("a.rapidity: ") && ContainsSubstring("is not recorded"));
        // What lies there can be watched, and a bookmark finds no place.
        CHECK(engine::read_sound_recording(folder / "whole.rapidity").end() == 300);
        CHECK_THROWS_AS(engine::keep_bookmark(folder / "whole.rapidity", {100, "here"}), sim::BadInput);
    }
    mode(static_cast<std::filesystem::perms>(0755));
}

TEST_CASE("a recording that is removed during the flight is told of") {
    const recorded_flight::Folder folder;
    const content::Scenario place = recorded_flight::scenario();
    engine::Recorder recorder(folder / "a.rapidity", engine::describe_flight(place), recorded_flight::start(place));
    recorded_flight::Flight flight(recorder, recorded_flight::start(place));
    flight.fly(100);
    std::filesystem::remove(folder / "a.rapidity");
    flight.fly(100);
    recorder.close();
    CHECK_THAT(recorder.trouble(), ContainsSubstring("removed or renamed"));
}

namespace {

/// While it lives, no file of this process grows beyond a size: a disk that is full, for root too.
class FullDisk {
  public:
    explicit FullDisk(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

/// Flies on until the recorder's trouble is, or is no longer, what is wanted.
void fly_until_trouble(recorded_flight::Flight& flight, const engine::Recorder& recorder, bool wanted) {
    for (int i = 0; i < 2000 && recorder.trouble().empty() == wanted; ++i) {
        flight.fly(100);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

} // namespace

TEST_CASE("on a full disk the flight goes on, what was committed is readable, and room mends all") {
    const recorded_flight::Folder folder;
    const auto file = folder / "a.rapidity";
    const content::Scenario place = recorded_flight::scenario();
    const engine::Recorder::Options quick{std::chrono::milliseconds(20), 1'000'000};
    engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place), quick);
    recorded_flight::Flight flight(recorder, recorded_flight::start(place));
    flight.fly(500);
    {
        const FullDisk full(600'000); // a few commits more
        fly_until_trouble(flight, recorder, true);
        REQUIRE_THAT(recorder.trouble(), ContainsSubstring("a.rapidity"));
        const engine::Recording part = engine::read_recording(file);
        CHECK(part.end() > 0);
        CHECK(part.end() < flight.state().tick);
        CHECK(engine::fly_again(part).ticks == part.end());
    }
    fly_until_trouble(flight, recorder, false);
    recorder.close();
    CHECK(recorder.trouble().empty());
    CHECK(engine::fly_again(engine::read_recording(file)).ticks == flight.state().tick);
}

TEST_CASE("a disk that stays full costs the rest of the recording, not the flight") {
    const recorded_flight::Folder folder;
    const auto file = folder / "a.rapidity";
    const content::Scenario place = recorded_flight::scenario();
    const engine::Recorder::Options small{std::chrono::milliseconds(20), 5000};
    engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place), small);
    recorded_flight::Flight flight(recorder, recorded_flight::start(place));
    const FullDisk full(200'000);
    fly_until_trouble(flight, recorder, true);
    flight.fly(20'000);
    recorder.close();
    CHECK_THAT(recorder.trouble(), ContainsSubstring("the rest of the flight is not recorded"));
    const engine::Recording part = engine::read_recording(file);
    CHECK_FALSE(part.ending);
    CHECK(engine::fly_again(part).ticks == part.end());
}

TEST_CASE("a disk that fills at any moment leaves a recording that opens and flies the same") {
    const content::Scenario place = recorded_flight::scenario();
    std::mt19937 random(std::random_device{}());
    std::uniform_int_distribution<rlim_t> room(90'000, 400'000); // from just after the tables to a few seconds
    for (int i = 0; i < 10; ++i) {
        const recorded_flight::Folder folder;
        const auto file = folder / "a.rapidity";
        const engine::Recorder::Options quick{std::chrono::milliseconds(5), 1'000'000};
        engine::Recorder recorder(file, engine::describe_flight(place), recorded_flight::start(place), quick);
        recorded_flight::Flight flight(recorder, recorded_flight::start(place));
        const FullDisk full(room(random));
        fly_until_trouble(flight, recorder, true);
        recorder.close();
        CHECK_FALSE(recorder.trouble().empty());
        const engine::Recording part = engine::read_recording(file);
        CHECK(engine::fly_again(part).ticks == part.end());
    }
}

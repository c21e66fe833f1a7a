#include "engine/recorder.h"
#include "engine/recording_file.h"
#include "engine/recording_format.h"
#include "engine/recording_header.h"
#include "engine/replay_check.h"
#include "input/replay_pilot.h"
#include "tests/xr/monado.h"
#include "tests/xr/watched_flight.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

namespace {

using Hashes = std::vector<std::uint64_t>;

/// Keeps every state's hash, and passes on what it hears.
class HashingSink final : public engine::TickSink {
  public:
    HashingSink(Hashes& hashes, std::unique_ptr<engine::Recorder> recorder)
        : hashes_(hashes), recorder_(std::move(recorder)) {}
    void on_tick(const sim::ControlFrame& control, const sim::VehicleState& after) override {
        hashes_.push_back(engine::present_layout().hash(after));
        if (recorder_) {
            recorder_->on_tick(control, after);
        }
    }
    void on_event(const sim::FlightEvent& event) override {
        if (recorder_) {
            recorder_->on_event(event);
        }
    }
    void on_change(const engine::FlightChange& change) override {
        if (recorder_) {
            recorder_->on_change(change);
        }
    }
    std::string trouble() const override { return recorder_ ? recorder_->trouble() : ""; }

  private:
    Hashes& hashes_;
    std::unique_ptr<engine::Recorder> recorder_;
};

} // namespace

TEST_CASE("a manoeuvre by the headset's controllers is, bit for bit, the flight of its demands from a file") {
    xr_kit::RemoteHeadset remote;
    const xr_kit::Folder folder;
    const std::filesystem::path file = folder.path / "manoeuvre.rapidity";
    content::Scenario scenario;
    scenario.name = "manoeuvre";
    scenario.speed_of_light = 30.0; // a head that moves is not slow here
    scenario.vehicle.maximum_acceleration = glm::dvec3(1.0);
    scenario.vehicle.maximum_turn_rate = glm::dvec3(1.0);
    Hashes flown;
    double fastest_head = 0.0;
    double most_thrust = 0.0;
    double most_turn = 0.0;
    bool boosted = false;
    bool braked = false;
    double fastest = 0.0;
    {
        auto recorder = std::make_unique<engine::Recorder>(file, engine::describe_flight(scenario),
                                                           engine::starting_change(scenario));
        engine::Recorder& closing = *recorder;
        xr_kit::WatchedFlight flight({}, scenario, std::make_unique<HashingSink>(flown, std::move(recorder)));
        for (int i = 0; i < 100; ++i) {
            // Ahead, then boosted and turning left, then braking; the head sways all the while.
            remote.head = {0.1F * std::sin(0.3F * static_cast<float>(i)), 1.6F, 0.0F};
            remote.right.trigger = i < 60 ? 1.0F : 0.0F;
            remote.right.a = i >= 30 && i < 60;
            remote.left.thumbstick = {i >= 30 && i < 70 ? -1.0F : 0.0F, 0.0F};
            remote.right.b = i >= 75;
            remote.send();
            REQUIRE(flight.next_frame());
            const sim::ControlFrame& control = flight.flight.control();
            fastest_head = std::max(fastest_head, glm::length(control.head_velocity));
            most_thrust = std::max(most_thrust, -control.proper_acceleration.z);
            most_turn = std::max(most_turn, control.angular_velocity.y);
            boosted = boosted || control.has(sim::ControlFrame::boost);
            braked = braked || control.has(sim::ControlFrame::brake);
            fastest = std::max(fastest, sim::rapidity(flight.flight.state().world_from_vehicle).value);
            CHECK(std::abs(control.head_position.x) < 0.3 / 30.0);
        }
        closing.close();
        CHECK(closing.trouble().empty());
    }
    CHECK(most_thrust > 1.5); // boosted beyond the limit of 1
    CHECK(most_turn > 0.9);   // the left stick to the left turns the nose to the left
    CHECK(boosted);
    CHECK(braked);
    CHECK(fastest > 0.5);
    CHECK(fastest_head > 0.01); // 0.6 m/s where light goes 30 m/s

    const engine::Recording recording = engine::read_recording(file);
    REQUIRE(recording.ending.has_value());
    REQUIRE(recording.end() == static_cast<sim::Tick>(flown.size()));
    input::ReplayPilot pilot(recording.controls, recording.end());
    Hashes again;
    engine::Flight flight(scenario, std::make_unique<HashingSink>(again, nullptr));
    while (flight.tick(pilot)) {
    }
    CHECK(again == flown);
}

#include "engine/flight.h"
#include "engine/frame_builder.h"
#include "input/script_pilot.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

using engine::Flight;

namespace {

content::Scenario fast_start() {
    content::Scenario scenario;
    scenario.speed_of_light = 10.0;
    scenario.start_position = {5.0, 2.0, -20.0};
    scenario.start_look = {1.0, 0.0, 0.0};
    scenario.start_beta = 0.8;
    scenario.start_heading = {0.0, 0.0, -2.0};
    return scenario;
}

/// A second of thrust and turn about skew axes.
input::ScriptPilot tumbling_pilot() {
    return {{{sim::ProperTime(1.0), {0.5, -0.25, 1.5}, {0.75, 2.0, -1.0}}}, 240.0};
}

double distance(const sim::VehicleState& a, const sim::VehicleState& b) {
    const sim::SpinMatrix d = a.world_from_vehicle.spin + (-1.0) * b.world_from_vehicle.spin;
    return glm::distance(a.event.space, b.event.space) + std::abs(a.event.t - b.event.t) +
           std::sqrt(sim::frobenius2(d));
}

/// Keeps what it hears.
class Ear final : public engine::TickSink {
  public:
    explicit Ear(std::vector<std::string>& heard) : heard_(heard) {}
    void on_tick(const sim::ControlFrame& /*control*/, const sim::VehicleState& after) override {
        heard_.push_back("tick " + std::to_string(after.tick));
    }
    void on_event(const sim::FlightEvent& event) override {
        heard_.push_back(std::string(sim::event_name(event.kind)) + " at " + std::to_string(event.tick));
    }
    void on_change(const engine::FlightChange& change) override {
        heard_.push_back(change.what + " at " + std::to_string(change.state.tick));
    }
    std::string trouble() const override { return "deaf"; }

  private:
    std::vector<std::string>& heard_;
};

} // namespace

TEST_CASE("a flight starts where, as fast and looking as the scenario says") {
    const sim::VehicleState state = engine::starting_state(fast_start());
    CHECK(state.event.space == glm::dvec3(0.5, 0.2, -2.0));
    CHECK(state.event.t == 0.0);
    // gamma = 5/3, gamma beta = 4/3; the boost and the rotation round a few times.
    const auto u = sim::four_velocity(state.world_from_vehicle);
    CHECK(u.t == Catch::Approx(5.0 / 3.0).epsilon(1e-15));
    CHECK(u.space.z == Catch::Approx(-4.0 / 3.0).epsilon(1e-15));
    // The nose (-z of the vehicle) is square to the motion, so the boost leaves it along +x; up stays up.
    const auto axes = sim::tetrad(state.world_from_vehicle);
    CHECK(glm::distance(axes[3].space, glm::dvec3(-1.0, 0.0, 0.0)) < 1e-15);
    CHECK(glm::distance(axes[2].space, glm::dvec3(0.0, 1.0, 0.0)) < 1e-15);
}

TEST_CASE("looking straight up has a defined, right-handed orientation") {
    content::Scenario scenario;
    scenario.start_look = {0.0, 3.0, 0.0};
    const auto axes = sim::tetrad(engine::starting_state(scenario).world_from_vehicle);
    CHECK(glm::distance(axes[3].space, glm::dvec3(0.0, -1.0, 0.0)) < 1e-15);
    CHECK(glm::distance(glm::cross(axes[1].space, axes[2].space), axes[3].space) < 1e-15);
}

TEST_CASE("frames between ticks are continuous and meet the ticks") {
    Flight flight(fast_start(), nullptr);
    input::ScriptPilot pilot = tumbling_pilot();
    sim::VehicleState last = flight.between(1.0);
    for (int tick = 0; tick < 20; ++tick) {
        REQUIRE(flight.tick(pilot));
        CHECK(distance(flight.between(0.0), last) == 0.0);
        CHECK(distance(flight.between(1.0), flight.state()) == 0.0);
        // RK4 over a part and over the whole tick differ by their truncation, (1/240)^5 times a few.
        CHECK(distance(flight.between(1.0 - 1e-12), flight.state()) < 1e-10);
        // Halfway by one half step is halfway by two quarter steps, to the same truncation: no kink inside a tick.
        const sim::VehicleState quarter = flight.between(0.25);
        const sim::VehicleState half = flight.between(0.5);
        const sim::VehicleState two_quarters =
            sim::step(quarter, sim::ProperTime(0.25 / 240.0),
                      {flight.state().felt_acceleration, flight.state().angular_velocity});
        CHECK(distance(half, two_quarters) < 1e-10);
        CHECK(half.ship_clock.value == Catch::Approx((tick + 0.5) / 240.0));
        last = flight.between(1.0);
    }
}

TEST_CASE("a pilot's end ends the ticks and changes nothing") {
    Flight flight(fast_start(), nullptr);
    input::ScriptPilot pilot = tumbling_pilot();
    sim::Tick ticks = 0;
    while (flight.tick(pilot)) {
        ++ticks;
    }
    CHECK(ticks == 240);
    CHECK(flight.state().tick == 240);
}

TEST_CASE("a flight stops for good before it leaves what can be computed, and stands still in range") {
    // A thrust that gets there in a few ticks (RK4 falls short of its 40 a tick), and some that overflow within one.
    for (const sim::FlightSegment& beyond :
         {sim::FlightSegment{sim::ProperTime(1.0), {0.0, 0.0, -9600.0}, {}},
          sim::FlightSegment{sim::ProperTime(1.0), {1e200, 0.0, 0.0}, {}},
          sim::FlightSegment{sim::ProperTime(1.0), {0.0, 1e308, 1e308}, {1e308, 0.0, 0.0}}}) {
        std::vector<std::string> heard;
        Flight flight(fast_start(), std::make_unique<Ear>(heard));
        input::ScriptPilot pilot({beyond}, 240.0);
        while (flight.tick(pilot)) {
        }
        CHECK(flight.state().tick < 30);
        CHECK(sim::is_in_range(flight.state()));
        CHECK(flight.stop() == "stopped at tick " + std::to_string(flight.state().tick) +
                                   ": the next takes the ship beyond rapidity 300, the end of what is computed");
        CHECK(heard.back() == flight.stop() + " at " + std::to_string(flight.state().tick));
        CHECK(heard.size() == flight.state().tick + 1);
        CHECK_FALSE(flight.tick(pilot));
        CHECK(distance(flight.between(0.5), flight.state()) == 0.0);
    }
}

TEST_CASE("another speed of light keeps place, motion and the path between the ticks") {
    Flight flight(fast_start(), nullptr);
    input::ScriptPilot pilot = tumbling_pilot();
    for (int tick = 0; tick < 10; ++tick) {
        flight.tick(pilot);
    }
    const sim::VehicleState before = flight.state();
    const glm::dvec3 place = before.event.space * flight.metres_per_light_unit();
    flight.set_speed_of_light(2.5);
    CHECK(flight.speed_of_light() == 2.5);
    CHECK(glm::distance(flight.state().event.space * flight.metres_per_light_unit(), place) < 1e-14); // 20 m, rounded
    CHECK(flight.state().world_from_vehicle.spin == before.world_from_vehicle.spin);
    CHECK(distance(flight.between(1.0 - 1e-12), flight.state()) < 1e-10);
}

TEST_CASE("another speed of light keeps the target's place in the scene, and a new target begins the trip anew") {
    std::vector<std::string> heard;
    Flight flight(fast_start(), std::make_unique<Ear>(heard));
    flight.set_target({{1.0, -2.0, 3.0}, {0.5, 0.0, 0.0}}, "a church");
    flight.set_cruise(sim::Rapidity(0.25));
    flight.set_speed_of_light(5.0);
    CHECK(flight.state().guidance.target.position_at_zero == glm::dvec3(2.0, -4.0, 6.0));
    CHECK(flight.state().guidance.target.velocity == glm::dvec3(0.5, 0.0, 0.0));
    CHECK(flight.state().guidance.cruise.value == 0.25);
    CHECK(flight.state().guidance.phase == sim::AutopilotPhase::off);
    CHECK(heard == std::vector<std::string>{"target = a church at 0", "cruise rapidity = 0.25 at 0",
                                            "speed of light = 5 m/s at 0"});
}

TEST_CASE("the picture has the head's own velocity in it") {
    /// Looks on and steps to the right.
    class Stepping final : public input::Pilot {
        std::optional<sim::ControlFrame> control(sim::Tick /*tick*/) override {
            sim::ControlFrame frame;
            frame.head_velocity = {0.25, 0.0, 0.0};
            return frame;
        }
    } stepping;
    content::Scenario still = fast_start();
    still.start_beta = 0.0;
    still.start_look = {0.0, 0.0, -1.0};
    Flight flight(still, nullptr);
    flight.tick(stepping);
    const render::RenderFrame frame = engine::build_frame(flight, flight.state(), glm::dquat(1.0, 0.0, 0.0, 0.0),
                                                          engine::starting_picture(still), 0.0);
    CHECK(sim::four_velocity(frame.eye.world_from_head).space.x == Catch::Approx(0.25 / std::sqrt(1.0 - 0.0625)));
}

TEST_CASE("the sink hears every tick and change, in order, and its trouble is told") {
    std::vector<std::string> heard;
    Flight flight(fast_start(), std::make_unique<Ear>(heard));
    input::ScriptPilot pilot = tumbling_pilot();
    flight.tick(pilot);
    flight.set_speed_of_light(30.0);
    flight.tick(pilot);
    flight.set_vehicle({}, "limits off");
    CHECK(heard == std::vector<std::string>{"tick 1", "speed of light = 30 m/s at 1", "tick 2", "limits off at 2"});
    CHECK(flight.trouble() == "deaf");
}

TEST_CASE("the frame shows the ship in scene metres and knows the light-year") {
    Flight flight(fast_start(), nullptr);
    const render::RenderFrame frame = engine::build_frame(flight, flight.state(), glm::dquat(1.0, 0.0, 0.0, 0.0),
                                                          engine::starting_picture(fast_start()), 0.0);
    CHECK(glm::distance(frame.eye.position, glm::dvec3(5.0, 2.0, -20.0)) < 1e-14);
    CHECK(frame.metres_per_light_year == 315576000.0);
    CHECK(frame.eye.world_from_head.spin == flight.state().world_from_vehicle.spin);
}

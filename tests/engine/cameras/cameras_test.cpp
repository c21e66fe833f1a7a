#include "content/flight_script.h"
#include "engine/cameras/cameras.h"
#include "engine/fly/recorded_flight.h"
#include "engine/frame_builder.h"
#include "engine/recording_file.h"
#include "engine/replay_deck.h"
#include "input/script_pilot.h"
#include "sim/bad_input.h"
#include "tests/engine/command.h"
#include "tests/engine/recorded_flight.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double metres = 20.0;
const glm::dquat straight(1.0, 0.0, 0.0, 0.0);

content::Scenario empty_scenario() {
    content::Scenario scenario;
    scenario.name = "empty";
    scenario.speed_of_light = metres;
    return scenario;
}

sim::FlightScript legs(const std::vector<std::pair<double, double>>& duration_and_thrust) {
    sim::FlightScript script;
    for (const auto& [duration, ahead] : duration_and_thrust) {
        script.push_back({sim::ProperTime(duration), {0.0, 0.0, -ahead}, glm::dvec3(0.0)});
    }
    return script;
}

void fly(engine::Flight& flight, const sim::FlightScript& script) {
    input::ScriptPilot pilot(script, flight.vehicle().tick_rate);
    while (flight.tick(pilot)) {
    }
}

engine::Flight flown(const content::Scenario& scenario, const sim::FlightScript& script) {
    engine::Flight flight(scenario, nullptr);
    flight.keep_world_line();
    fly(flight, script);
    return flight;
}

render::RenderFrame pilots_frame(const engine::Flight& flight) {
    return engine::build_frame(flight, flight.state(), straight, engine::PictureSettings(), 0.0);
}

render::RenderFrame frame_of(const engine::Cameras& cameras, const engine::Flight& flight) {
    render::RenderFrame frame = pilots_frame(flight);
    cameras.apply(flight, flight.state(), straight, frame);
    return frame;
}

engine::CameraSettings settings(engine::CameraKind kind) {
    engine::CameraSettings settings;
    settings.kind = kind;
    return settings;
}

/// Flies and records a flight.
std::string record(const recorded_flight::Folder& folder, const std::string& name, const content::Scenario& scenario,
                   const sim::FlightScript& script) {
    engine::RecordedFlight recorded(scenario, folder / name);
    fly(recorded.flight(), script);
    REQUIRE(recorded.close().empty());
    return (folder / name).string();
}

using tests::rapidity;

} // namespace

TEST_CASE("the pilot's own camera stays as it is, bit for bit, with other ships or without") {
    const engine::Flight flight = flown(empty_scenario(), legs({{1.0, 0.8}}));
    const render::RenderFrame plain = pilots_frame(flight);
    sim::VehicleState other;
    const engine::OtherShip ghost{"ghost", std::make_shared<const sim::ShipWorldLine>(other), 1.0, false};
    for (const std::vector<engine::OtherShip>& others : {std::vector<engine::OtherShip>{}, {ghost}}) {
        const engine::Cameras cameras(empty_scenario(), {}, others);
        const render::RenderFrame frame = frame_of(cameras, flight);
        CHECK(frame.eye.position == plain.eye.position);
        CHECK(frame.eye.world_from_head.spin == plain.eye.world_from_head.spin);
        CHECK(frame.moving.ships.size() == others.size());
        CHECK(cameras.idle() == others.empty());
    }
}

TEST_CASE("the world's camera sees a ship that comes at 0.9 c by its light, and its clock run fast") {
    content::Scenario scenario = empty_scenario();
    scenario.start_beta = 0.9;
    scenario.start_heading = {0.0, 0.0, -1.0};
    engine::CameraSettings at = settings(engine::CameraKind::world);
    at.place = glm::dvec3(0.0, 0.0, -20.0 * metres);
    at.look = glm::dvec3(0.0, 0.0, 1.0);
    const engine::Cameras cameras(scenario, at, {});
    const engine::Flight flight = flown(scenario, legs({{4.0, 0.0}}));
    const double gamma = 1.0 / std::sqrt(1.0 - 0.81);
    const double now = 4.0 * gamma; // by the world's clock
    const std::vector<engine::ClockReading> clocks = cameras.clocks(flight, frame_of(cameras, flight));
    REQUIRE(clocks.size() == 1);
    // Light that left at t, from 0.9 t along the way, is there at t + 20 - 0.9 t.
    const double left = (now - 20.0) / (1.0 - 0.9);
    CHECK_THAT(clocks[0].seen, WithinAbs(left / gamma, 1e-9)); // before its start, too, it came as fast
    CHECK_THAT(clocks[0].now, WithinAbs(4.0, 1e-11));
    CHECK_THAT(clocks[0].wavelength_ratio, WithinRel(std::sqrt(0.1 / 1.9), 1e-12));
    CHECK_THAT(clocks[0].direction.z, WithinAbs(-1.0, 1e-12)); // it looks at the ship
    CHECK_THAT(cameras.reading(flight, flight.state()).clock, WithinAbs(now, 1e-11));
}

TEST_CASE("a moving world camera is an inertial observer with its own clock, turned to the ship") {
    engine::CameraSettings moving = settings(engine::CameraKind::world);
    moving.place = glm::dvec3(100.0, 0.0, 0.0);
    moving.velocity = {0.0, 0.6, 0.0};
    const engine::Cameras cameras(empty_scenario(), moving, {});
    const engine::Flight flight = flown(empty_scenario(), legs({{2.0, 0.0}}));
    const render::RenderFrame frame = frame_of(cameras, flight);
    const sim::FourVector<sim::World> u = sim::four_velocity(frame.eye.world_from_head);
    CHECK_THAT(glm::length(u.space - glm::dvec3(0.0, 0.75, 0.0)), WithinAbs(0.0, 1e-14));
    CHECK_THAT(glm::length(frame.eye.position - glm::dvec3(100.0, 2.0 * 0.6 * metres, 0.0)), WithinAbs(0.0, 1e-11));
    CHECK_THAT(cameras.reading(flight, flight.state()).clock, WithinAbs(2.0 * 0.8, 1e-14));
    const engine::ClockReading seen = cameras.clocks(flight, frame).at(0);
    CHECK_THAT(seen.direction.z, WithinAbs(-1.0, 1e-12));
    // A ship at rest at the distance r, by light of that delay; aberration changes where it is seen, not when.
    CHECK_THAT(seen.seen, WithinAbs(2.0 - std::hypot(5.0, 1.2), 1e-12));
}

TEST_CASE("the chase camera rests in the ship's frame, and its clock is that of a lower floor") {
    const double a = 0.5;
    engine::CameraSettings behind = settings(engine::CameraKind::chase);
    behind.place = glm::dvec3(0.0, 0.0, 10.0);
    const engine::Cameras cameras(empty_scenario(), behind, {});
    const engine::Flight flight = flown(empty_scenario(), legs({{3.0, a}}));
    const render::RenderFrame frame = frame_of(cameras, flight);
    const double r = 10.0 / metres;
    // Rindler: a point behind by r is on the hyperbola of radius 1/a - r, at the same rapidity (RK4: 1e-11).
    CHECK_THAT(frame.eye.position.z / metres, WithinAbs(1.0 / a - (1.0 / a - r) * std::cosh(a * 3.0), 1e-9));
    CHECK_THAT(frame.moving.world_time, WithinAbs((1.0 / a - r) * std::sinh(a * 3.0), 1e-9));
    CHECK_THAT(cameras.reading(flight, flight.state()).clock, WithinAbs((1.0 - a * r) * 3.0, 1e-9));
    CHECK(frame.eye.world_from_head.spin == pilots_frame(flight).eye.world_from_head.spin);
    // The light of the ship's middle takes long enough to climb down that it shows an earlier time: for Rindler's
    // observers, ln of the ratio of their radii over a.
    const engine::ClockReading ship = cameras.clocks(flight, frame).at(0);
    CHECK_THAT(ship.seen, WithinAbs(3.0 + std::log(1.0 - a * r) / a, 1e-9));
    CHECK_THAT(ship.wavelength_ratio, WithinRel(1.0 - a * r, 1e-9)); // blue, falling down to the eye
}

TEST_CASE("the twins meet again with clocks apart by the closed form") {
    const content::Scenario scenario = content::load_scenario("twins");
    const engine::Flight flight = flown(scenario, content::load_flight_script(scenario.demonstration));
    const engine::Cameras twin(scenario, settings(engine::CameraKind::twin), engine::other_ships(scenario, {}));
    const double a = 0.7;
    const double own = 4 * 3.0 + 2 * 2.0;
    const double others = 4 * std::sinh(a * 3.0) / a + 2 * 2.0;
    CHECK_THAT(flight.state().ship_clock.value, WithinAbs(own, 1e-12));
    // RK4 at 240 Hz to rapidity 2.1: 1e-11 of 27 clock units.
    CHECK_THAT(flight.state().event.t - flight.state().ship_clock.value, WithinAbs(others - own, 1e-9));
    CHECK_THAT(glm::length(flight.state().event.space * scenario.metres_per_light_unit() - scenario.start_position),
               WithinAbs(0.0, 1e-7));
    CHECK_THAT(sim::rapidity(flight.state().world_from_vehicle).value, WithinAbs(0.0, 1e-9));
    // The one who stayed reads his own clock, and sees the other's by the light that came over.
    CHECK_THAT(twin.reading(flight, flight.state()).clock, WithinAbs(others, 1e-9));
    const double apart =
        glm::length(scenario.start_position - scenario.beacons.at(0).position) / scenario.metres_per_light_unit();
    const engine::ClockReading ship = twin.clocks(flight, frame_of(twin, flight)).at(0);
    CHECK_THAT(ship.seen, WithinAbs(own - apart, 1e-9));
    CHECK_THAT(ship.now, WithinAbs(own, 1e-9));
}

TEST_CASE("a recording joins a flight as a ghost, with its clock as it is seen") {
    const recorded_flight::Folder folder;
    const content::Scenario scenario = empty_scenario();
    const double a = 0.6;
    const std::string ghost = record(folder, "out.rapidity", scenario, legs({{2.0, a}}));
    const engine::Cameras cameras(scenario, {}, engine::other_ships(scenario, {ghost}));
    for (const double wait : {0.5, 2.5, 6.0}) {
        const engine::Flight flight = flown(scenario, legs({{wait, 0.0}})); // at rest where the ghost began
        const engine::ClockReading seen = cameras.clocks(flight, frame_of(cameras, flight)).at(0);
        // Light that left at the ghost's time tau is here at (e^(a tau) - 1)/a; it coasts after its end.
        const double end = (std::exp(a * 2.0) - 1.0) / a;
        const double expected = wait < end ? std::log(1.0 + a * wait) / a : 2.0 + (wait - end) * std::exp(-a * 2.0);
        CHECK_THAT(seen.seen, WithinAbs(expected, 1e-9));
        CHECK(seen.name == "out");
        CHECK_THAT(seen.wavelength_ratio, WithinRel(std::exp(std::min(a * expected, a * 2.0)), 1e-8));
    }
}

TEST_CASE("ghosts of other scenes and other speeds of light are refused in one line") {
    const recorded_flight::Folder folder;
    content::Scenario scenario = empty_scenario();
    const std::string ghost = record(folder, "ghost.rapidity", scenario, legs({{0.5, 0.1}}));
    const auto refusal = [&](const content::Scenario& here) {
        try {
            engine::other_ships(here, {ghost});
        } catch (const sim::BadInput& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal(scenario).empty());
    content::Scenario slower = scenario;
    slower.speed_of_light = 10.0;
    CHECK_THAT(refusal(slower), ContainsSubstring("ghost.rapidity") && ContainsSubstring("speed of light"));
    content::Scenario elsewhere = scenario;
    elsewhere.name = "elsewhere";
    CHECK_THAT(refusal(elsewhere), ContainsSubstring("elsewhere"));
    CHECK(rapidity({"fly", "street", "--headless", "--ghost", ghost, "--seconds", "0", "--stills",
                    (folder / "stills").string(), "--record", (folder / "r.rapidity").string()}) == 2);
}

TEST_CASE("who takes over a replay has its past, and others see it") {
    const recorded_flight::Folder folder;
    const content::Scenario scenario = empty_scenario();
    engine::ReplayDeck deck(engine::read_sound_recording(record(folder, "r.rapidity", scenario, legs({{3.0, 0.5}}))));
    deck.seek(2.0 * 240.0);
    const sim::ShipWorldLine whole = deck.world_line();
    engine::Flight flight(scenario, nullptr);
    flight.begin_at(deck.branch());
    flight.keep_world_line(deck.world_line_until_now());
    CHECK_THAT(flight.world_line()->last().value, WithinAbs(2.0, 1e-12));
    CHECK(whole.last().value == 3.0);
    fly(flight, legs({{5.0, 0.0}})); // a script that goes on from its third clock unit
    CHECK(flight.world_line()->last() == flight.state().ship_clock);
    CHECK(flight.world_line()->at(sim::ProperTime(1.0)).event == whole.at(sim::ProperTime(1.0)).event);
}

TEST_CASE("options of cameras that make no sense end with one line and exit code 2") {
    using Words = std::vector<std::string>;
    for (const Words& wrong : {Words{"--camera", "side"}, Words{"--camera", "twin"}, Words{"--camera-at", "1,2,3"},
                               Words{"--camera", "world", "--camera-velocity", "0,1,0"},
                               Words{"--camera", "chase", "--camera-velocity", "0,0.5,0"},
                               Words{"--camera", "world", "--camera-look", "0,0,0"},
                               Words{"--camera", "world", "--camera-at", "1,2"}, Words{"--ghost", "/no/such/file"}}) {
        const recorded_flight::Folder folder;
        Words words{"fly",
                    "stars",
                    "--headless",
                    "--seconds",
                    "0",
                    "--stills",
                    (folder / "stills").string(),
                    "--record",
                    (folder / "r.rapidity").string()};
        words.insert(words.end(), wrong.begin(), wrong.end());
        CAPTURE(wrong);
        CHECK(rapidity(words) == 2);
    }
}

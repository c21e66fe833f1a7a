#include "engine/failure.h"
#include "engine/navigation.h"
#include "engine/recorder.h"
#include "engine/recording_file.h"
#include "engine/replay_check.h"
#include "engine/voyage.h"
#include "input/autopilot_pilot.h"
#include "sim/bad_input.h"
#include "tests/engine/command.h"
#include "tests/engine/recorded_flight.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <glm/geometric.hpp>

#include <fstream>

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using Catch::Matchers::WithinRel;

namespace {

engine::VoyageOptions to(const std::string& where) {
    return {where, {}, {}, {}};
}

} // namespace

TEST_CASE("Alpha Centauri and a star a thousand light-years away at 1 g: the flight keeps its forecast") {
    const content::Scenario stars = content::load_scenario("stars");
    for (const char* where : {"Alpha Centauri", "Delta Cephei"}) {
        const engine::Voyage voyage = engine::plan_voyage(stars, to(where));
        const engine::FlownVoyage flown = engine::fly_voyage(voyage, [](const sim::VehicleState&) {});
        CHECK_NOTHROW(engine::compare_with_plan(voyage, flown));
        // The textbook's trip: cosh(a tau / 2) = 1 + a d / 2; whole ticks and the reserve for corrections are 1e-3.
        const double a = stars.vehicle.maximum_acceleration.z;
        CHECK_THAT(flown.end.ship_clock.value, WithinRel(2.0 * std::acosh(1.0 + 0.5 * a * voyage.distance) / a, 1e-3));
        CHECK(flown.events.size() == 3);
    }
    CHECK(engine::plan_voyage(stars, to("Delta Cephei")).distance > 980.0);
}

TEST_CASE("a recorded voyage is small, re-flies bit for bit, and tells its events") {
    const recorded_flight::Folder folder;
    const content::Scenario stars = content::load_scenario("stars");
    const engine::Voyage voyage = engine::plan_voyage(stars, to("Alpha Centauri"));
    const auto file = folder / "voyage.rapidity";
    sim::Tick ticks = 0;
    std::vector<sim::FlightEvent> events;
    {
        engine::Flight flight(stars, std::make_unique<engine::Recorder>(file, engine::describe_flight(stars),
                                                                        engine::starting_change(stars)));
        flight.set_target(voyage.destination.object, voyage.destination.name);
        input::AutopilotPilot pilot;
        while (flight.state().guidance.phase == sim::AutopilotPhase::off ||
               sim::is_flying(flight.state().guidance.phase)) {
            REQUIRE(flight.tick(pilot));
            REQUIRE(++ticks < 8000);
        }
        events = flight.events();
    }
    const engine::Recording recording = engine::read_sound_recording(file);
    CHECK(recording.controls.size() == 1); // the autopilot was switched on
    CHECK(engine::fly_again(recording).ticks == ticks);
    REQUIRE(recording.events.size() == events.size());
    REQUIRE(events.size() == 3);
    for (std::size_t i = 0; i < events.size(); ++i) {
        CHECK(recording.events[i].what == sim::event_name(events[i].kind));
        CHECK(recording.events[i].tick == events[i].tick);
        CHECK(recording.events[i].ship_clock == events[i].ship_clock);
        CHECK(recording.events[i].world_clock == events[i].world_clock);
    }
    // A second of hands-on flight is about as large: snapshots apart, a trip is a handful of rows.
    CHECK(std::filesystem::file_size(file) < 200'000);
}

TEST_CASE("trips that cannot be flown are refused with value and range") {
    const content::Scenario stars = content::load_scenario("stars");
    const auto refused = [&](engine::VoyageOptions options, const char* a, const char* b) {
        CHECK_THROWS_MATCHES(engine::plan_voyage(stars, options), sim::BadInput,
                             MessageMatches(ContainsSubstring(a) && ContainsSubstring(b)));
    };
    refused({"Sirius", "1e-12", "", ""}, "--to = Sirius", "thrust of 1e-12 c/yr is too small");
    refused({"Sirius", "-1", "", ""}, "--acceleration = -1", "must lie in");
    refused({"Sirius", "", "", "2"}, "--exhaust-speed = 2", "[1e-09, 1]");
    refused({"Sirius", "", "-3", ""}, "--propellant = -3", "must lie in");
    refused({"Sirius", "", "0", ""}, "--to = Sirius", "rapidity of 0");
}

TEST_CASE("the verbs refuse contradictions and take goals") {
    const recorded_flight::Folder folder;
    const std::string table = (folder / "out.csv").string();
    CHECK(tests::rapidity({"simulate", "stars", "--to", "Tau Ceti", "--csv", table, "--every", "500"}) == 0);
    std::ifstream stream(table);
    std::string header;
    std::getline(stream, header);
    CHECK_THAT(header, ContainsSubstring("ship_clock [clock unit]") && ContainsSubstring("gamma [1]"));
    std::size_t rows = 0;
    for (std::string line; std::getline(stream, line);) {
        ++rows;
    }
    CHECK(rows > 15); // 5 years of 2000 ticks each
    CHECK(tests::rapidity({"plan", "stars", "--to", "Tau Ceti", "--json"}) == 0);
    CHECK(tests::rapidity({"plan", "stars"}) == 2);
    CHECK(tests::rapidity({"simulate"}) == 2);
    CHECK(tests::rapidity({"simulate", "--script", "a.csv", "--to", "Vega"}) == 2);
    CHECK(tests::rapidity({"fly", "stars", "--script", "a.csv", "--to", "Vega"}) == 2);
    std::ofstream(folder / "script.csv") << "duration,ax,ay,az,wx,wy,wz\n1,0,0,-5,0,0,0\n";
    CHECK(tests::rapidity({"simulate", "stars", "--script", (folder / "script.csv").string(), "--csv", table}) == 2);
    CHECK(tests::rapidity({"simulate", "--script", (folder / "script.csv").string(), "--csv", table}) == 0);
}

TEST_CASE("with slower light a beacon's trip changes its scale, a star's does not") {
    content::Scenario scenario = content::load_scenario("stars");
    scenario.beacons.push_back({"buoy", {9.4607304725808e15, 0.0, 0.0}, {}}); // a light-year
    engine::Navigation navigation(scenario);
    engine::Flight flight(scenario, nullptr);
    const auto index = [&](const std::string& name) {
        const auto& all = navigation.destinations();
        return static_cast<std::size_t>(std::ranges::find(all, name, &content::Destination::name) - all.begin());
    };
    const auto target_distance = [&] { return glm::length(flight.state().guidance.target.position_at_zero); };
    navigation.choose(flight, index("Sirius"));
    const double star = target_distance();
    flight.set_speed_of_light(299792458.0 / 4.0);
    navigation.rescale(flight);
    CHECK_THAT(target_distance(), WithinRel(star, 1e-14));
    CHECK(navigation.target(flight) == index("Sirius"));
    navigation.choose(flight, index("buoy"));
    CHECK_THAT(target_distance(), WithinRel(4.0, 1e-12));
    flight.set_speed_of_light(299792458.0);
    navigation.rescale(flight);
    CHECK_THAT(target_distance(), WithinRel(1.0, 1e-12));
    CHECK(navigation.target(flight) == index("buoy"));
    // What the instruments show at the start: the clock at home reads 0, the buoy's a year ago.
    const engine::NavigationReading reading = navigation.read(flight, flight.state(), glm::dquat(1.0, 0.0, 0.0, 0.0));
    REQUIRE(reading.clocks.size() == 2);
    CHECK(reading.clocks[0].seen == 0.0);
    CHECK_THAT(reading.clocks[1].seen, WithinRel(-1.0, 1e-12));
    CHECK(reading.target.name == "buoy");
    CHECK_THAT(reading.forecast, ContainsSubstring("gamma up to 1.516")); // 1 + a d / 2
}

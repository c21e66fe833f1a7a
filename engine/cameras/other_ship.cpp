#include "engine/cameras/other_ship.h"

#include "engine/recording_file.h"
#include "engine/replay_deck.h"
#include "sim/bad_input.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace engine {
namespace {

OtherShip beacon_ship(const content::Beacon& beacon, double metres_per_light_unit) {
    sim::VehicleState state;
    state.event.space = beacon.position / metres_per_light_unit;
    if (const double speed = glm::length(beacon.velocity); speed > 0.0) {
        state.world_from_vehicle =
            sim::boost<sim::World, sim::Vehicle>(sim::Rapidity(std::atanh(speed)), beacon.velocity / speed);
    }
    return {beacon.name, std::make_shared<const sim::ShipWorldLine>(state), 1.0, true};
}

/// Refuses a recording of another scene. What counts are the files it was made of, whatever the scenario is called.
void check_scene(const std::string& file, const RecordingHeader& header, const content::Scenario& scenario) {
    const RecordingHeader here = describe_flight(scenario);
    const auto checksum = [](const RecordingHeader& of, const std::string& role) {
        const auto found = std::ranges::find(of.inputs, role, &InputFile::role);
        return found == of.inputs.end() ? std::uint64_t{0} : found->checksum;
    };
    if (header.scenario_name != here.scenario_name) {
        throw sim::BadInput(file, "scenario", header.scenario_name,
                            fmt::format("was flown elsewhere: a ghost needs the scene of {}", here.scenario_name));
    }
    for (const char* role : {"scenario", "model"}) {
        if (checksum(header, role) != checksum(here, role)) {
            throw sim::BadInput(file, role, header.scenario_name,
                                "has changed since this flight: its ghost would be in another scene");
        }
    }
}

OtherShip ghost(const std::filesystem::path& path, const content::Scenario& scenario) {
    Recording recording = read_sound_recording(path);
    check_scene(path.string(), recording.header, scenario);
    for (const FlightChange& change : recording.changes) {
        if (change.metres_per_light_unit != scenario.metres_per_light_unit()) {
            throw sim::BadInput(path.string(), "speed of light",
                                fmt::format("{:g}", change.metres_per_light_unit / scenario.clock_unit_seconds),
                                fmt::format("a ghost needs the one of this flight, {:g} m/s", scenario.speed_of_light));
        }
    }
    const double thrust = full_thrust(recording.changes.front().vehicle);
    ReplayDeck deck(std::move(recording));
    return {path.stem().string(), std::make_shared<const sim::ShipWorldLine>(deck.world_line()), thrust, false};
}

} // namespace

double full_thrust(const sim::VehicleSettings& vehicle) {
    const double along = vehicle.maximum_acceleration.z;
    return std::isfinite(along) ? along : 1.0;
}

std::vector<OtherShip> other_ships(const content::Scenario& scenario,
                                   const std::vector<std::filesystem::path>& ghosts) {
    std::vector<OtherShip> ships;
    for (const content::Beacon& beacon : scenario.beacons) {
        if (beacon.ship) {
            ships.push_back(beacon_ship(beacon, scenario.metres_per_light_unit()));
        }
    }
    for (const std::filesystem::path& path : ghosts) {
        ships.push_back(ghost(path, scenario));
    }
    return ships;
}

} // namespace engine

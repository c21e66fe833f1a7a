#pragma once

#include "content/scenario.h"
#include "sim/ship_world_line.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace engine {

/// A ship that somebody else flies, or has flown.
struct OtherShip {
    std::string name;
    std::shared_ptr<const sim::ShipWorldLine> world_line;
    double full_thrust = 1.0; ///< c per clock unit
    bool is_beacon = false;   ///< the instruments show its clock already
};

/// The scenario's beacons that are ships, then the recordings. A recording is a ship on its recorded world line; before
/// its start and after its end it coasts. Throws sim::BadInput for one that is none or is damaged, was flown in another
/// scene, or with another speed of light than `scenario` has.
std::vector<OtherShip> other_ships(const content::Scenario& scenario, const std::vector<std::filesystem::path>& ghosts);

/// Thrust along the ship at which its flames are full.
double full_thrust(const sim::VehicleSettings& vehicle);

} // namespace engine

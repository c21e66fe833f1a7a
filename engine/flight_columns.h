#pragma once

#include "sim/vehicle.h"

#include <array>
#include <string>
#include <vector>

/// Where a ship is and how it moves, as columns for people and other programs: tau,t,x,y,z and the tetrad e0_t ... e3_z
/// (components of the vehicle's axes in the world).
namespace engine {

inline constexpr std::size_t flight_column_count = 21;

std::vector<std::string> flight_columns();
/// flight_columns with their units: "t [clock unit]".
std::vector<std::string> flight_header();
std::array<double, flight_column_count> flight_values(const sim::VehicleState& state);

} // namespace engine

#pragma once

#include "sim/flight_script.h"

#include <filesystem>

namespace content {

/// Reads a flight script: a CSV with exactly the columns duration,ax,ay,az,wx,wy,wz in any order, one segment a row;
/// clock units of ship time, c per clock unit and radians per clock unit in vehicle axes. Throws sim::BadInput with
/// file, line, column and value when a number is not finite, a duration is not above zero, a column is missing or
/// unknown, or there is no row.
sim::FlightScript load_flight_script(const std::filesystem::path& file);

} // namespace content

#pragma once

#include "engine/recording_file.h"

#include <filesystem>
#include <string>

namespace engine {

/// Header and rows of such a table, each with its line's end: every field of the state and what the instruments show.
std::string flight_table_header();
std::string flight_table_row(const sim::VehicleState& state);

/// Writes a recorded flight as CSV, flown again and compared on the way: every field of the state and what the
/// instruments show, with units in the header, at the start, after every `every`-th tick (> 0) and at the end. Numbers
/// read back as the same doubles. Throws sim::BadInput when the file cannot be written, Failure when the flight differs
/// from its recording.
void write_flight_table(const Recording& recording, sim::Tick every, const std::filesystem::path& file);

} // namespace engine

#pragma once

#include "engine/recording_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace engine {

enum class TableFormat : std::uint8_t {
    csv,  ///< "name [unit]" in the header line
    json, ///< {"recording", "columns": [{"name", "unit", "meaning"}], "rows": [[...]]}
};

/// What of a recorded flight is written, and how often.
struct TableRequest {
    std::vector<std::string> columns; ///< names; empty: the usual ones
    double ticks_per_row = 240.0;     ///< > 0; between two ticks the ship is flown part of one
    TableFormat format = TableFormat::csv;
};

/// Writes a recorded flight as a table: at the start, after every `ticks_per_row`, and at the end. Numbers read back as
/// the same doubles. Throws sim::BadInput for a column that there is not, naming all that there are, and when the file
/// cannot be written.
void write_flight_table(const Recording& recording, const TableRequest& request, const std::filesystem::path& file);

/// Header and rows of the usual columns as CSV, each with its line's end.
std::string flight_table_header();
std::string flight_table_row(const sim::VehicleState& state);

/// A line for each column: name, unit, meaning.
std::vector<std::string> table_columns();

} // namespace engine

#pragma once

#include "content/csv.h"
#include "engine/flight_columns.h"
#include "sim/flight_script.h"

#include <array>
#include <vector>

namespace engine {

/// One flight of flights.csv, from rest at the origin.
struct TrueFlight {
    std::string name;
    sim::FlightScript script;
    std::vector<std::array<double, flight_column_count>> ends; ///< flight_columns at the end of each segment
};

/// The flights of a table with the columns of flights.csv. Throws sim::BadInput for a missing column or a bad number.
std::vector<TrueFlight> read_true_flights(const content::CsvTable& table);

} // namespace engine

#pragma once

#include <filesystem>
#include <string>

namespace engine {

/// A new file for the recording of a flight that starts now: <scenario>-<date>-<time>.rapidity (local time) in
/// $RAPIDITY_FLIGHTS_DIR, or in flights/ of the current folder. Creates the folder and reserves the name by an empty
/// file, so that nothing is ever overwritten; a folder that cannot be written is left for the recorder to report.
std::filesystem::path new_flight_file(const std::string& scenario_name);

} // namespace engine

#pragma once

#include <filesystem>
#include <string>

namespace engine {

/// Where flights leave their files unless told otherwise: $RAPIDITY_FLIGHTS_DIR, or flights/ of the current folder.
std::filesystem::path flights_folder();

/// A new file for the recording of a flight that starts now: <scenario>-<date>-<time>.rapidity (local time) in
/// `folder`. Creates the folder and reserves the name by an empty file, so that nothing is ever overwritten; a folder
/// that cannot be written is left for the recorder to report.
std::filesystem::path new_flight_file(const std::string& scenario_name,
                                      const std::filesystem::path& folder = flights_folder());

} // namespace engine

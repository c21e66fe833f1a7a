#pragma once

#include "content/scenario.h"

#include <filesystem>

namespace content {

/// A scenario's TOML, and whether it says where the flight starts.
struct ScenarioFile {
    Scenario scenario;
    bool has_start_position = false;
};

/// Reads one file by the table of scenario_keys(). Throws sim::BadInput with file, key and value: a key that is not
/// known (naming the nearest), of the wrong type, out of range or not finite; a file that is not there.
ScenarioFile read_scenario_file(const std::filesystem::path& file);

} // namespace content

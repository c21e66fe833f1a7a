#pragma once

#include "content/scenario.h"

#include <cstdint>
#include <string>
#include <vector>

namespace engine {

/// A file that a scenario was made of.
struct InputFile {
    std::string role; ///< "scenario", "model", "panorama"
    std::string file; ///< absolute
    std::uint64_t checksum = 0;
};

/// What a recording says about its flight as a whole.
struct RecordingHeader {
    std::string program_version;
    std::string started;       ///< UTC, ISO 8601
    std::string scenario;      ///< absolute path of the scenario's or the bare model's file
    std::string scenario_name; ///< a built-in scenario is found by it on a machine where the path is another
    std::string title;         ///< one line
    std::string scenario_text; ///< the scenario's TOML in full; "" for a bare model
    double clock_unit_seconds = 1.0;
    std::string clock_unit_name;
    double pace = 1.0; ///< clock units of ship time per second of the pilot's time at the start
    std::vector<InputFile> inputs;
    std::string origin; ///< the recording that this one was made of: branched off, or recovered; "" for most

    std::uint64_t checksum() const;
};

/// The header of a flight through `scenario` that starts now. Reads the scenario's files for their checksums; one that
/// cannot be read is left out.
RecordingHeader describe_flight(const content::Scenario& scenario);

/// One line for each input file that is gone or not what it was: the flight is the same, what it shows is not.
std::vector<std::string> changed_inputs(const RecordingHeader& header);

} // namespace engine

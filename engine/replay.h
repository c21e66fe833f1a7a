#pragma once

#include "content/scenario.h"
#include "engine/recording_file.h"
#include "input/pilot.h"

#include <memory>
#include <string>
#include <vector>

namespace engine {

/// What it takes to show a recorded flight again: Flight(scenario), follow(changes), tick(*pilot).
struct Replay {
    content::Scenario scenario;        ///< with the recorded vehicle, speed of light and pace
    std::vector<FlightChange> changes; ///< the first is the start
    std::unique_ptr<input::Pilot> pilot;
    std::vector<std::string> warnings; ///< one line for each file of the scenario that is not what it was
};

/// Throws sim::BadInput for a recording that is none or is damaged, or whose scenario cannot be loaded.
Replay load_replay(const std::filesystem::path& file);

} // namespace engine

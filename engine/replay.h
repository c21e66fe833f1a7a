#pragma once

#include "content/scenario.h"
#include "engine/recording_file.h"

#include <string>
#include <vector>

namespace engine {

/// What it takes to show a recorded flight again.
struct Replay {
    content::Scenario scenario; ///< with the recorded vehicle, speed of light and pace
    Recording recording;
    std::vector<std::string> warnings; ///< one line for each file of the scenario that is not what it was
};

/// Throws sim::BadInput for a recording that is none or is damaged, or whose scenario cannot be loaded.
Replay load_replay(const std::filesystem::path& file);

} // namespace engine

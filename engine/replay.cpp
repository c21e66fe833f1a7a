#include "engine/replay.h"

#include <utility>

namespace engine {

Replay load_replay(const std::filesystem::path& file) {
    Recording recording = read_sound_recording(file);
    Replay replay;
    replay.warnings = changed_inputs(recording.header);
    const std::string& path = recording.header.scenario;
    replay.scenario = content::load_scenario(std::filesystem::exists(path) ? path : recording.header.scenario_name);
    replay.scenario.vehicle = recording.changes.front().vehicle;
    replay.scenario.speed_of_light =
        recording.changes.front().metres_per_light_unit / replay.scenario.clock_unit_seconds;
    replay.scenario.pace = recording.header.pace;
    replay.recording = std::move(recording);
    return replay;
}

} // namespace engine

#pragma once

#include "sim/quantities.h"

#include <filesystem>
#include <string>
#include <vector>

namespace engine {

/// What was saved of the flight behind a hole: a recording of its own that starts at a recorded snapshot.
struct LaterPart {
    std::filesystem::path file;
    sim::Tick first = 0;
    sim::Tick saved_until = 0;
};

/// What was saved of a damaged recording.
struct Recovery {
    sim::Tick first = 0;
    sim::Tick saved_until = 0;       ///< the last tick that the flight, flown again, shares with a recorded hash
    sim::Tick known_until = 0;       ///< the last tick that anything in the file tells of
    bool head_poses_checked = true;  ///< false: the last part is proved by the ship's state alone
    std::vector<LaterPart> later;    ///< by rising tick; their head poses are unchecked
    std::vector<std::string> losses; ///< one line for each table that is not all there
};

/// Writes what is sound of `damaged` to the new recording `rescued`: the flight as flown again from its start, up to
/// the last tick at which it meets a recorded hash. Each part behind it that leads, flown again, from one recorded
/// snapshot to a later one becomes a recording of its own, RESCUED-2.rapidity and so on. `damaged` stays as it is.
/// Throws sim::BadInput where nothing can be saved, when a file to be written is there already or cannot be written.
Recovery recover_recording(const std::filesystem::path& damaged, const std::filesystem::path& rescued);

} // namespace engine

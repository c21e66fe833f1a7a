#pragma once

#include "sim/quantities.h"

#include <filesystem>
#include <string>
#include <vector>

namespace engine {

/// What was saved of a damaged recording.
struct Recovery {
    sim::Tick first = 0;
    sim::Tick saved_until = 0;       ///< the last tick that the flight, flown again, shares with a recorded hash
    sim::Tick known_until = 0;       ///< the last tick that anything in the file tells of
    bool head_poses_checked = true;  ///< false: the last part is proved by the ship's state alone
    std::vector<std::string> losses; ///< one line for each table that is not all there
};

/// Writes what is sound of `damaged` to the new recording `rescued`: the flight as flown again from its start, up to
/// the last tick at which it meets a recorded hash. `damaged` stays as it is. Throws sim::BadInput where nothing can be
/// saved, when `rescued` is there already or cannot be written.
Recovery recover_recording(const std::filesystem::path& damaged, const std::filesystem::path& rescued);

} // namespace engine

#pragma once

#include "engine/recording_file.h"

#include <functional>

namespace engine {

/// What a comparison of a recording with its flight flown again covered.
struct ReplayReport {
    sim::Tick ticks = 0;
    std::size_t hashes = 0; ///< compared, all equal
};

/// Hears of every state of a flight, the start first.
using StateVisitor = std::function<void(const sim::VehicleState&)>;

/// Flies a recorded flight again, from its start, its demands and its changes, with the simulation's own code, and
/// compares the hash of the state wherever the recording has one. Throws Failure at the first that differs, naming
/// the tick, and for a damaged recording.
ReplayReport fly_again(const Recording& recording, const StateVisitor& visit = {});

} // namespace engine

#pragma once

#include "engine/replay_deck.h"

#include <vector>

namespace engine {

/// The ship at one of a recording's snapshots, for curves along the flight.
struct TimelinePoint {
    sim::Tick tick = 0;
    double thrust = 0.0; ///< felt acceleration, c per clock unit
    double beta = 0.0;
    double gamma = 1.0;
};

/// Start, snapshots and end, thinned evenly to at most `most` points (>= 2), by rising tick.
std::vector<TimelinePoint> timeline(const Recording& recording, std::size_t most);

} // namespace engine

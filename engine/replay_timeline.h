#pragma once

#include "engine/replay_deck.h"

#include <vector>

namespace engine {

/// The ship at one tick of a recording, for curves along the flight.
struct TimelinePoint {
    sim::Tick tick = 0;
    double thrust = 0.0; ///< felt acceleration, c per clock unit
    double beta = 0.0;
    double gamma = 1.0;
};

/// Start, end and ticks evenly between them, at most `most` (>= 2) in all, by rising tick. The recording must be sound.
std::vector<TimelinePoint> timeline(const Recording& recording, std::size_t most);

} // namespace engine

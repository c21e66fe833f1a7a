#pragma once

#include "engine/recording_file.h"

#include <optional>
#include <string>
#include <vector>

namespace engine {

/// How two recorded flights compare, tick by tick of their own clocks.
struct RecordingDifference {
    sim::Tick from = 0;                    ///< both have been flown
    sim::Tick until = 0;                   ///< from here to here
    std::optional<sim::Tick> demands_part; ///< first tick with another demand
    std::optional<sim::Tick> states_part;  ///< first tick after which the states are not bit for bit the same
    std::vector<std::string> fields;       ///< "event_x: 1.5, 1.5000001": what differs then
    // Where both end:
    double separation = 0.0;            ///< of their places in the world, light clock units
    double world_time_difference = 0.0; ///< b's less a's world clock, clock units
    sim::Rapidity relative_rapidity;    ///< of one in the other's rest frame
    sim::Tick length_a = 0;
    sim::Tick length_b = 0;

    bool same() const { return !demands_part && !states_part && length_a == length_b; }
};

RecordingDifference difference(const Recording& a, const Recording& b);

} // namespace engine

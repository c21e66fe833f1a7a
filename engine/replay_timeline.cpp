#include "engine/replay_timeline.h"

#include "sim/readings.h"

namespace engine {
namespace {

TimelinePoint point_of(const sim::VehicleState& state) {
    const sim::Readings shown = sim::readings(state);
    return {state.tick, shown.felt_acceleration, shown.beta, shown.gamma};
}

} // namespace

std::vector<TimelinePoint> timeline(const Recording& recording, std::size_t most) {
    std::vector<TimelinePoint> points{point_of(recording.changes.front().state)};
    const std::vector<sim::VehicleState>& snapshots = recording.snapshots;
    const std::size_t inner = most - 2;
    const std::size_t count = std::min(snapshots.size(), inner);
    for (std::size_t i = 0; i < count; ++i) {
        points.push_back(point_of(snapshots[i * snapshots.size() / count]));
    }
    if (recording.end() > points.back().tick) {
        ReplayDeck deck(recording);
        deck.seek(static_cast<double>(recording.end()));
        points.push_back(point_of(deck.state()));
    }
    return points;
}

} // namespace engine

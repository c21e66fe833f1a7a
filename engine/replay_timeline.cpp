#include "engine/replay_timeline.h"

#include "sim/readings.h"

#include <algorithm>

namespace engine {
namespace {

TimelinePoint point_of(const sim::VehicleState& state) {
    const sim::Readings shown = sim::readings(state);
    return {state.tick, shown.felt_acceleration, shown.beta, shown.gamma};
}

} // namespace

std::vector<TimelinePoint> timeline(const Recording& recording, std::size_t most) {
    ReplayDeck deck(recording);
    const sim::Tick span = deck.end() - deck.first();
    const sim::Tick steps = std::min<sim::Tick>(most - 1, span);
    std::vector<TimelinePoint> points{point_of(deck.moment().before)};
    for (sim::Tick i = 1; i <= steps; ++i) {
        deck.seek(static_cast<double>(deck.first() + span * i / steps));
        points.push_back(point_of(deck.moment().before));
    }
    return points;
}

} // namespace engine

#include "engine/replay_deck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace engine {
namespace {

constexpr std::array speeds{0.01, 0.02, 0.05, 0.1,  0.2,   0.5,   1.0,   2.0,
                            5.0,  10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0};
constexpr std::size_t recorded_speed = 6;
static_assert(speeds[recorded_speed] == 1.0);

std::vector<ReplayMark> marks_of(const Recording& recording) {
    std::vector<ReplayMark> marks;
    for (const FlightChange& change : recording.changes) {
        marks.push_back({change.state.tick, change.what});
    }
    for (const RecordedEvent& event : recording.events) {
        marks.push_back({event.tick, event.what});
    }
    for (const Bookmark& bookmark : recording.bookmarks) {
        marks.push_back({bookmark.tick, bookmark.what});
    }
    marks.push_back({recording.end(), "end"});
    std::stable_sort(marks.begin(), marks.end(),
                     [](const ReplayMark& a, const ReplayMark& b) { return a.tick < b.tick; });
    return marks;
}

/// The last snapshot at or before a tick; the number of snapshots when there is none.
std::size_t snapshot_before(const std::vector<sim::VehicleState>& snapshots, sim::Tick tick) {
    const auto after = std::upper_bound(snapshots.begin(), snapshots.end(), tick,
                                        [](sim::Tick t, const sim::VehicleState& state) { return t < state.tick; });
    return after == snapshots.begin() ? snapshots.size() : static_cast<std::size_t>(after - snapshots.begin()) - 1;
}

} // namespace

sim::ControlFrame demand_at(const Recording& recording, sim::Tick tick) {
    const std::vector<input::TimedControl>& demands = recording.controls;
    const auto after = std::upper_bound(demands.begin(), demands.end(), tick,
                                        [](sim::Tick t, const input::TimedControl& timed) { return t < timed.tick; });
    return after == demands.begin() ? sim::ControlFrame() : std::prev(after)->control;
}

ReplayDeck::ReplayDeck(Recording recording)
    : recording_(std::move(recording)), speed_(recorded_speed), marks_(marks_of(recording_)) {
    start_from_anchor(first());
    seek(static_cast<double>(first()));
}

double ReplayDeck::speed() const {
    return speeds.at(speed_);
}

void ReplayDeck::faster() {
    speed_ = std::min(speed_ + 1, speeds.size() - 1);
}

void ReplayDeck::slower() {
    speed_ = speed_ == 0 ? 0 : speed_ - 1;
}

void ReplayDeck::seek(double position) {
    position_ = std::clamp(position, static_cast<double>(first()), static_cast<double>(end()));
    fly_to(static_cast<sim::Tick>(position_));
    show();
}

void ReplayDeck::step(std::int64_t ticks) {
    const double whole = std::floor(position_);
    const double from = ticks < 0 && position_ > whole ? whole + 1.0 : whole;
    seek(from + static_cast<double>(ticks));
}

void ReplayDeck::advance(double seconds) {
    if (paused_) {
        return;
    }
    const double rate = recording_.header.pace * moment_.vehicle.tick_rate * speed() * (backwards_ ? -1.0 : 1.0);
    seek(position_ + seconds * rate);
    paused_ = backwards_ ? position_ <= static_cast<double>(first()) : position_ >= static_cast<double>(end());
}

Bookmark ReplayDeck::mark() {
    const auto marked =
        std::ranges::count_if(marks_, [](const ReplayMark& mark) { return mark.what.starts_with("bookmark"); });
    const std::string what = fmt::format("bookmark: {}", marked + 1);
    const auto after = std::upper_bound(marks_.begin(), marks_.end(), state_.tick,
                                        [](sim::Tick t, const ReplayMark& mark) { return t < mark.tick; });
    marks_.insert(after, {state_.tick, what});
    return {state_.tick, what};
}

void ReplayDeck::seek_mark(bool next) {
    // While it plays, the mark just passed is not the one that is meant.
    const double grace = paused_ ? 0.0 : moment_.vehicle.tick_rate * recording_.header.pace;
    const ReplayMark* found = nullptr;
    for (const ReplayMark& mark : marks_) {
        const auto tick = static_cast<double>(mark.tick);
        if (next && tick > position_) {
            found = &mark;
            break;
        }
        if (!next && tick < position_ - grace) {
            found = &mark;
        }
    }
    if (found != nullptr || !next) {
        seek(static_cast<double>(found != nullptr ? found->tick : first()));
    }
}

void ReplayDeck::fly_to(sim::Tick tick) {
    if (tick < state_.tick || tick > state_.tick + snapshot_interval) {
        start_from_anchor(tick);
    }
    while (state_.tick < tick) {
        fly_one();
    }
}

void ReplayDeck::start_from_anchor(sim::Tick tick) {
    const auto after = std::upper_bound(recording_.changes.begin() + 1, recording_.changes.end(), tick,
                                        [](sim::Tick t, const FlightChange& change) { return t < change.state.tick; });
    make_change(static_cast<std::size_t>(after - recording_.changes.begin()) - 1);
    const std::size_t snapshot = snapshot_before(recording_.snapshots, tick);
    if (snapshot < recording_.snapshots.size() && recording_.snapshots[snapshot].tick > state_.tick) {
        state_ = recording_.snapshots[snapshot];
    }
}

void ReplayDeck::make_change(std::size_t index) {
    change_ = index;
    state_ = recording_.changes[index].state;
}

sim::VehicleState ReplayDeck::next_state() const {
    return sim::advance(state_, recording_.changes[change_].vehicle, demand_at(recording_, state_.tick));
}

void ReplayDeck::fly_one() {
    state_ = next_state();
    if (state_.tick % snapshot_interval == 0) {
        const std::size_t snapshot = snapshot_before(recording_.snapshots, state_.tick);
        if (snapshot < recording_.snapshots.size() && recording_.snapshots[snapshot].tick == state_.tick) {
            state_ = recording_.snapshots[snapshot];
        }
    }
    while (change_ + 1 < recording_.changes.size() && recording_.changes[change_ + 1].state.tick <= state_.tick) {
        make_change(change_ + 1);
    }
}

void ReplayDeck::show() {
    const bool at_end = state_.tick >= end();
    moment_.before = state_;
    moment_.after = at_end ? state_ : next_state();
    moment_.control_before = state_.tick > 0 ? demand_at(recording_, state_.tick - 1) : sim::ControlFrame();
    moment_.control = demand_at(recording_, at_end && end() > first() ? end() - 1 : state_.tick);
    moment_.vehicle = recording_.changes[change_].vehicle;
    moment_.metres_per_light_unit = recording_.changes[change_].metres_per_light_unit;
    moment_.fraction = at_end ? 0.0 : position_ - std::floor(position_);
}

sim::ShipWorldLine ReplayDeck::world_line_to(sim::Tick tick) const {
    ReplayDeck flown = *this;
    flown.start_from_anchor(first());
    sim::ShipWorldLine line(flown.state_);
    while (flown.state_.tick < tick) {
        flown.fly_one();
        line.extend(flown.state_);
    }
    return line;
}

FlightChange ReplayDeck::branch() const {
    return {"start of a branch", state_, moment_.vehicle, moment_.metres_per_light_unit};
}

std::string ReplayDeck::branch_origin() const {
    return fmt::format("branch of {} at tick {}; state hash there {:016x}, recording's checksum {:016x}",
                       recording_.file.filename().string(), state_.tick, recording_.layout.hash(state_),
                       recording_.checksum());
}

} // namespace engine

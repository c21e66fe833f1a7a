#include "engine/replay_check.h"

#include "engine/failure.h"
#include "engine/recording_format.h"

#include <fmt/format.h>

namespace engine {
namespace {

class Flown {
  public:
    Flown(const Recording& recording, const StateVisitor& visit)
        : recording_(recording), visit_(visit), pilot_(recording.controls, recording.end()),
          state_(recording.changes.front().state), settings_(recording.changes.front().vehicle) {}

    void advance_to(sim::Tick tick) {
        while (state_.tick < tick) {
            apply_changes([this](std::size_t i) { return recording_.changes[i].state.tick <= state_.tick; });
            state_ = sim::advance(state_, settings_, pilot_.control(state_.tick).value());
            if (!sim::is_in_range(state_)) {
                throw Failure(fmt::format("{}: tick {} leaves what can be computed (rapidity {:g})",
                                          recording_.file.string(), state_.tick, sim::largest_rapidity.value));
            }
            ++report_.ticks;
            compare_snapshot();
            if (visit_) {
                visit_(state_);
            }
        }
    }

    void compare(const Heartbeat& heartbeat) {
        apply_changes([&heartbeat](std::size_t i) { return i < heartbeat.changes; });
        compare(heartbeat.state_hash);
    }

    const ReplayReport& report() const { return report_; }

  private:
    template <class Due>
    void apply_changes(const Due& due) {
        for (; next_change_ < recording_.changes.size() && due(next_change_); ++next_change_) {
            state_ = recording_.changes[next_change_].state;
            settings_ = recording_.changes[next_change_].vehicle;
        }
    }

    void compare_snapshot() {
        if (state_.tick % snapshot_interval == 0 && next_snapshot_ < recording_.snapshots.size() &&
            recording_.snapshots[next_snapshot_].tick == state_.tick) {
            compare(recording_.snapshot_hashes[next_snapshot_]);
            ++next_snapshot_;
        }
    }

    void compare(std::uint64_t recorded) {
        const std::uint64_t flown = recording_.layout.hash(state_);
        if (flown != recorded) {
            const std::string why = recording_.damage ? "; " + recording_.damage->what
                                                      : "; recorded by Rapidity " + recording_.header.program_version;
            throw Failure(fmt::format("{}: flies differently: at tick {} the state's hash is {:016x}, recorded was "
                                      "{:016x}{}",
                                      recording_.file.string(), state_.tick, flown, recorded, why));
        }
        ++report_.hashes;
    }

    const Recording& recording_;
    const StateVisitor& visit_;
    input::ReplayPilot pilot_;
    sim::VehicleState state_;
    sim::VehicleSettings settings_;
    std::size_t next_change_ = 1;
    std::size_t next_snapshot_ = 0;
    ReplayReport report_;
};

} // namespace

ReplayReport fly_again(const Recording& recording, const StateVisitor& visit) {
    Flown flown(recording, visit);
    if (visit) {
        visit(recording.changes.front().state);
    }
    for (const Heartbeat& heartbeat : recording.heartbeats) {
        if (recording.damage && heartbeat.tick > recording.damage->tick) {
            break;
        }
        flown.advance_to(heartbeat.tick);
        flown.compare(heartbeat);
    }
    if (recording.damage) {
        throw Failure(fmt::format("{}: damaged at tick {}: {}", recording.file.string(), recording.damage->tick,
                                  recording.damage->what));
    }
    return flown.report();
}

} // namespace engine

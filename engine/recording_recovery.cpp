#include "engine/recording_recovery.h"

#include "engine/recording_file.h"
#include "engine/recording_writer.h"
#include "input/replay_pilot.h"
#include "sim/bad_input.h"
#include "sim/flight_log.h"

#include <algorithm>
#include <fmt/format.h>

namespace engine {
namespace {

/// Flies what is left of a recording from its start, and compares it with what it meets.
class Remains {
  public:
    Remains(const Recording& recording, sim::Tick end)
        : recording_(recording), pilot_(recording.controls, end), end_(end), state_(recording.changes.front().state),
          settings_(recording.changes.front().vehicle) {
        add(changes_, recording_.changes.front(), recording_.layout);
    }

    /// Compares and then flies, tick by tick, until the end or where no further can be flown.
    void fly(Recovery& recovery) {
        while (true) {
            compare(recovery);
            if (state_.tick >= end_) {
                return;
            }
            for (; control_ < recording_.controls.size() && recording_.controls[control_].tick <= state_.tick;
                 ++control_) {
                add(controls_, recording_.controls[control_], recording_.layout);
            }
            state_ = sim::advance(state_, settings_, pilot_.control(state_.tick).value());
            if (!sim::is_in_range(state_)) {
                return;
            }
        }
    }

  private:
    void compare(Recovery& recovery) {
        compare_with_snapshot(recovery);
        compare_with_heartbeats(recovery);
        while (next_change_ < recording_.changes.size() && recording_.changes[next_change_].state.tick <= state_.tick) {
            make_change();
            compare_with_heartbeats(recovery);
        }
    }

    void make_change() {
        const FlightChange& change = recording_.changes[next_change_++];
        state_ = change.state;
        settings_ = change.vehicle;
        add(changes_, change, recording_.layout);
    }

    void compare_with_snapshot(Recovery& recovery) {
        const std::vector<sim::VehicleState>& snapshots = recording_.snapshots;
        for (; snapshot_ < snapshots.size() && snapshots[snapshot_].tick <= state_.tick; ++snapshot_) {
            if (snapshots[snapshot_].tick == state_.tick &&
                recording_.layout.hash(state_) == recording_.snapshot_hashes[snapshot_]) {
                recovery.saved_until = state_.tick;
                recovery.head_poses_checked = false; // until a heartbeat says so
            }
        }
    }

    void compare_with_heartbeats(Recovery& recovery) {
        const std::vector<Heartbeat>& heartbeats = recording_.heartbeats;
        for (; heartbeat_ < heartbeats.size() && heartbeats[heartbeat_].tick <= state_.tick &&
               heartbeats[heartbeat_].changes <= next_change_;
             ++heartbeat_) {
            const Heartbeat& heartbeat = heartbeats[heartbeat_];
            if (heartbeat.tick == state_.tick && heartbeat.changes == next_change_ &&
                heartbeat.state_hash == recording_.layout.hash(state_) &&
                heartbeat.controls_checksum == controls_.sum() && heartbeat.changes_checksum == changes_.sum()) {
                recovery.saved_until = state_.tick;
                recovery.head_poses_checked = true;
            }
        }
    }

    const Recording& recording_;
    input::ReplayPilot pilot_;
    sim::Tick end_;
    sim::VehicleState state_;
    sim::VehicleSettings settings_;
    Checksum controls_;
    Checksum changes_;
    std::size_t control_ = 0;
    std::size_t next_change_ = 1;
    std::size_t snapshot_ = 0;
    std::size_t heartbeat_ = 0;
};

sim::Tick known_until(const Recording& recording) {
    sim::Tick tick = recording.changes.back().state.tick;
    if (!recording.controls.empty()) {
        tick = std::max(tick, recording.controls.back().tick + 1);
    }
    for (const sim::VehicleState& state : recording.snapshots) {
        tick = std::max(tick, state.tick);
    }
    for (const Heartbeat& heartbeat : recording.heartbeats) {
        tick = std::max(tick, heartbeat.tick);
    }
    return std::max(tick, recording.ending.value_or(tick));
}

/// The last tick that any readable hash belongs to: beyond it nothing can be proved.
sim::Tick last_hash(const Recording& recording) {
    sim::Tick tick = recording.changes.front().state.tick;
    if (!recording.snapshots.empty()) {
        tick = std::max(tick, recording.snapshots.back().tick);
    }
    return recording.heartbeats.empty() ? tick : std::max(tick, recording.heartbeats.back().tick);
}

void write_part(const Recording& recording, sim::Tick end, const std::filesystem::path& file) {
    RecordingWriter writer(file, recording.header, recording.changes.front());
    input::ReplayPilot pilot(recording.controls, end);
    sim::FlightLog log;
    FlightBatch batch;
    batch.latest = recording.changes.front().state;
    sim::VehicleSettings settings = recording.changes.front().vehicle;
    std::size_t control = 0;
    std::size_t change = 1;
    std::size_t frame = 0;
    while (true) {
        for (; change < recording.changes.size() && recording.changes[change].state.tick <= batch.latest.tick;
             ++change) {
            batch.changes.push_back(recording.changes[change]);
            batch.latest = recording.changes[change].state;
            settings = recording.changes[change].vehicle;
        }
        const bool over = batch.latest.tick >= end;
        if (over || !batch.snapshots.empty()) {
            for (; control < recording.controls.size() && recording.controls[control].tick < batch.latest.tick;
                 ++control) {
                batch.controls.push_back(recording.controls[control]);
            }
            for (; frame < recording.frames.size() && recording.frames[frame].tick <= batch.latest.tick; ++frame) {
                batch.frames.push_back(recording.frames[frame]);
            }
            writer.write(batch);
            const sim::VehicleState latest = batch.latest;
            batch = {};
            batch.latest = latest;
        }
        if (over) {
            break;
        }
        const sim::VehicleState before = batch.latest;
        batch.latest = sim::advance(before, settings, pilot.control(before.tick).value());
        if (const std::optional<sim::FlightEvent> event = log.watch(before, batch.latest, settings)) {
            batch.events.push_back(*event);
        }
        if (batch.latest.tick % snapshot_interval == 0) {
            batch.snapshots.push_back(batch.latest);
        }
    }
    writer.finish(end);
}

} // namespace

Recovery recover_recording(const std::filesystem::path& damaged, const std::filesystem::path& rescued) {
    if (std::filesystem::exists(rescued)) {
        throw sim::BadInput(rescued.string(), "", "", "is there already; name a new file to save to");
    }
    Recovery recovery;
    Recording recording = read_remains(damaged, recovery.losses);
    recovery.first = recovery.saved_until = recording.first_tick();
    recovery.known_until = known_until(recording);
    recovery.head_poses_checked = false;
    bool proved = false;
    {
        Remains remains(recording, last_hash(recording));
        remains.fly(recovery);
        proved = recovery.saved_until > recovery.first || recovery.head_poses_checked;
    }
    if (!proved) {
        throw sim::BadInput(damaged.string(), "", "",
                            fmt::format("no part of it agrees with a recorded hash, nothing is saved{}",
                                        recovery.losses.empty() ? "" : "; " + recovery.losses.front()));
    }
    recording.header.origin = fmt::format("recovered from {}: ticks {} to {} of {}", damaged.filename().string(),
                                          recovery.first, recovery.saved_until, recovery.known_until);
    try {
        write_part(recording, recovery.saved_until, rescued);
    } catch (const DatabaseError& error) {
        throw sim::BadInput(rescued.string(), "", "", std::string("cannot be written: ") + error.what());
    }
    return recovery;
}

} // namespace engine

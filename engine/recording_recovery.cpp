#include "engine/recording_recovery.h"

#include "engine/recording_file.h"
#include "engine/recording_writer.h"
#include "engine/replay_deck.h"
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
            make_change(recovery);
            compare_with_heartbeats(recovery);
        }
    }

    void make_change(const Recovery& recovery) {
        const FlightChange& change = recording_.changes[next_change_++];
        const bool jumps = recording_.layout.hash(change.state) != recording_.layout.hash(state_);
        hides_the_past_ = hides_the_past_ || (jumps && recovery.saved_until != state_.tick);
        state_ = change.state;
        settings_ = change.vehicle;
        add(changes_, change, recording_.layout);
    }

    void compare_with_snapshot(Recovery& recovery) {
        const std::vector<sim::VehicleState>& snapshots = recording_.snapshots;
        for (; snapshot_ < snapshots.size() && snapshots[snapshot_].tick <= state_.tick; ++snapshot_) {
            if (!hides_the_past_ && snapshots[snapshot_].tick == state_.tick &&
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
                hides_the_past_ = false;
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
    /// A change of state has come since the last proof: later states tell nothing of what was flown before it. The sums
    /// of a heartbeat do.
    bool hides_the_past_ = false;
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

/// The flight from a snapshot on, as a recording: unproved. Its heartbeats go, whose sums begin at the flight's start.
Recording from_snapshot(const Recording& whole, std::size_t snapshot) {
    const sim::VehicleState& start = whole.snapshots[snapshot];
    Recording part = whole;
    const auto later_change = std::ranges::find_if(
        part.changes, [&start](const FlightChange& change) { return change.state.tick > start.tick; });
    FlightChange first = *std::prev(later_change); // the first change is the flight's start
    first.what = "start behind a hole";
    if (first.state.tick < start.tick) { // else it was changed at that very tick, behind the snapshot
        first.state = start;
    }
    part.changes.erase(part.changes.begin(), later_change);
    part.changes.insert(part.changes.begin(), first);
    const sim::ControlFrame held = demand_at(whole, start.tick);
    std::erase_if(part.controls, [&start](const input::TimedControl& timed) { return timed.tick <= start.tick; });
    part.controls.insert(part.controls.begin(), {start.tick, held});
    part.snapshots.erase(part.snapshots.begin(), part.snapshots.begin() + static_cast<std::ptrdiff_t>(snapshot) + 1);
    part.snapshot_hashes.erase(part.snapshot_hashes.begin(),
                               part.snapshot_hashes.begin() + static_cast<std::ptrdiff_t>(snapshot) + 1);
    part.heartbeats.clear();
    std::erase_if(part.frames, [&start](const ShownFrame& frame) { return frame.tick < start.tick; });
    return part;
}

/// A part behind a hole before it is written.
struct ProvedPart {
    Recording recording;
    LaterPart part;
};

/// The parts that lead from one snapshot to a later one, behind `from`.
std::vector<ProvedPart> later_parts(const Recording& recording, sim::Tick from) {
    std::vector<ProvedPart> parts;
    for (std::size_t i = 0; i + 1 < recording.snapshots.size(); ++i) {
        const sim::VehicleState& start = recording.snapshots[i];
        if (start.tick <= from || recording.layout.hash(start) != recording.snapshot_hashes[i]) {
            continue;
        }
        Recording part = from_snapshot(recording, i);
        const auto proved_until = [&](sim::Tick end) {
            Recovery recovery;
            recovery.saved_until = start.tick;
            Remains(part, end).fly(recovery);
            return recovery.saved_until;
        };
        if (proved_until(part.snapshots.front().tick) == start.tick) {
            continue; // it does not even reach the next one
        }
        from = proved_until(part.snapshots.back().tick);
        parts.push_back({std::move(part), {"", start.tick, from}});
    }
    return parts;
}

std::filesystem::path numbered(const std::filesystem::path& file, std::size_t number) {
    return file.parent_path() / fmt::format("{}-{}{}", file.stem().string(), number, file.extension().string());
}

void refuse_existing(const std::filesystem::path& file) {
    if (std::filesystem::exists(file)) {
        throw sim::BadInput(file.string(), "", "", "is there already; name a new file to save to");
    }
}

void write_proved(Recording& recording, const Recovery& recovery, const LaterPart& part,
                  const std::filesystem::path& damaged) {
    recording.header.origin = fmt::format("recovered from {}: ticks {} to {} of {}", damaged.filename().string(),
                                          part.first, part.saved_until, recovery.known_until);
    try {
        write_part(recording, part.saved_until, part.file);
        for (const Bookmark& bookmark : recording.bookmarks) {
            if (bookmark.tick >= part.first && bookmark.tick <= part.saved_until) {
                keep_bookmark(part.file, bookmark);
            }
        }
    } catch (const DatabaseError& error) {
        throw sim::BadInput(part.file.string(), "", "", std::string("cannot be written: ") + error.what());
    }
}

} // namespace

Recovery recover_recording(const std::filesystem::path& damaged, const std::filesystem::path& rescued) {
    refuse_existing(rescued);
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
    std::vector<ProvedPart> later = later_parts(recording, recovery.saved_until);
    for (std::size_t i = 0; i < later.size(); ++i) {
        later[i].part.file = numbered(rescued, i + 2);
        refuse_existing(later[i].part.file);
    }
    write_proved(recording, recovery, {rescued, recovery.first, recovery.saved_until}, damaged);
    for (ProvedPart& behind : later) {
        write_proved(behind.recording, recovery, behind.part, damaged);
        recovery.later.push_back(behind.part);
    }
    return recovery;
}

} // namespace engine

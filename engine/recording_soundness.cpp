#include "engine/recording_soundness.h"

#include "engine/checksum.h"
#include "engine/recording_format.h"

namespace engine {
namespace {

/// The first tick whose snapshot should be there and is not.
sim::Tick first_missing_snapshot(const Recording& recording) {
    sim::Tick expected = (recording.first_tick() / snapshot_interval + 1) * snapshot_interval;
    for (const sim::VehicleState& state : recording.snapshots) {
        if (state.tick != expected) {
            break;
        }
        expected += snapshot_interval;
    }
    return expected;
}

/// Demands and changes against the sums that every heartbeat holds.
std::optional<Damage> find_in_heartbeats(const Recording& recording) {
    const sim::Tick missing_snapshot = first_missing_snapshot(recording);
    Checksum controls;
    Checksum changes;
    std::size_t control = 0;
    std::size_t change = 0;
    sim::Tick tick = recording.first_tick();
    for (const Heartbeat& heartbeat : recording.heartbeats) {
        if (heartbeat.tick < tick) {
            return Damage{tick, "its heartbeats run backwards"};
        }
        if (heartbeat.tick >= missing_snapshot) {
            return Damage{missing_snapshot, "this tick's snapshot is missing"};
        }
        for (; control < recording.controls.size() && recording.controls[control].tick < heartbeat.tick; ++control) {
            add(controls, recording.controls[control], recording.layout);
        }
        for (; change < recording.changes.size() && change < heartbeat.changes; ++change) {
            add(changes, recording.changes[change], recording.layout);
        }
        if (controls.sum() != heartbeat.controls_checksum) {
            return Damage{heartbeat.tick, "the recorded demands do not match their checksum"};
        }
        if (change != heartbeat.changes || changes.sum() != heartbeat.changes_checksum) {
            return Damage{heartbeat.tick, "the recorded changes do not match their checksum"};
        }
        tick = heartbeat.tick;
    }
    if (control != recording.controls.size() || change != recording.changes.size() ||
        tick + snapshot_interval < missing_snapshot) {
        return Damage{tick, "it holds more than its last heartbeat tells of"};
    }
    return std::nullopt;
}

std::optional<Damage> find_in_snapshots(const Recording& recording) {
    for (std::size_t i = 0; i < recording.snapshots.size(); ++i) {
        const sim::VehicleState& state = recording.snapshots[i];
        if (recording.layout.hash(state) != recording.snapshot_hashes[i]) {
            return Damage{state.tick, "the snapshot does not match its hash"};
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Damage> find_damage(const Recording& recording) {
    std::optional<Damage> first = find_in_heartbeats(recording);
    const std::optional<Damage> other = find_in_snapshots(recording);
    if (!first || (other && other->tick < first->tick)) {
        first = other;
    }
    if (!first && recording.ending && *recording.ending != recording.end()) {
        first = Damage{recording.end(), "its end is missing"};
    }
    return first;
}

} // namespace engine

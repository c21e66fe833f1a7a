#pragma once

#include "engine/bookmarks.h"
#include "engine/recording_format.h"
#include "engine/recording_header.h"
#include "engine/tick_sink.h"
#include "input/replay_pilot.h"
#include "sim/vehicle.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// The state of a flight at one moment, told by its hash alone.
struct Heartbeat {
    sim::Tick tick = 0;
    std::size_t changes = 0; ///< how many of Recording::changes had happened
    std::uint64_t state_hash = 0;
    std::uint64_t controls_checksum = 0;
    std::uint64_t changes_checksum = 0;
};

/// A departure, flip or arrival, as it stands in the file.
struct RecordedEvent {
    sim::Tick tick = 0;
    std::string what;
    sim::ProperTime ship_clock;
    sim::CoordinateTime world_clock;
};

/// A contradiction within a recording: it was altered after it was written.
struct Damage {
    sim::Tick tick; ///< up to here at the latest it is sound
    std::string what;
};

/// A recorded flight, read whole.
struct Recording {
    std::filesystem::path file;
    RecordingHeader header;
    RecordingLayout layout;            ///< what its hashes and checksums cover
    std::vector<FlightChange> changes; ///< the first is the start
    std::vector<input::TimedControl> controls;
    std::vector<sim::VehicleState> snapshots; ///< after every snapshot_interval-th tick
    std::vector<std::uint64_t> snapshot_hashes;
    std::vector<Heartbeat> heartbeats;
    std::vector<RecordedEvent> events;
    std::vector<ShownFrame> frames;  ///< of a headset
    std::vector<Bookmark> bookmarks; ///< in the file and beside it
    std::optional<sim::Tick> ending; ///< none: the program ended without closing the file
    std::optional<Damage> damage;    ///< the first, by tick

    sim::Tick first_tick() const { return changes.front().state.tick; }
    sim::Tick end() const { return heartbeats.back().tick; }
    /// Of all that was flown: two recordings with the same are the same flight of the same scenario.
    std::uint64_t checksum() const;
};

/// Reads a recording and checks it against its checksums; what does not fit is told by Recording::damage. Throws
/// sim::BadInput for a file that is no recording, holds no flight, was made by a newer version, or cannot be read.
Recording read_recording(const std::filesystem::path& file);

/// What can still be read of a recording, however damaged: rows up to the first damaged one of each table, of demands
/// and snapshots also those behind the last, unchecked. Appends a line for each part that is not all there to `losses`.
/// Throws sim::BadInput where there is nothing.
Recording read_remains(const std::filesystem::path& file, std::vector<std::string>& losses);

/// read_recording for uses that need all of it to be right: throws sim::BadInput when it is damaged.
Recording read_sound_recording(const std::filesystem::path& file);

} // namespace engine

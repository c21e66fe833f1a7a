#pragma once

#include "engine/database.h"
#include "engine/recording_format.h"
#include "engine/recording_header.h"

#include <filesystem>
#include <vector>

namespace engine {

/// What happened in a flight between two commits.
struct FlightBatch {
    std::vector<input::TimedControl> controls; ///< each differs from the one before
    std::vector<FlightChange> changes;
    std::vector<sim::VehicleState> snapshots; ///< after every snapshot_interval-th tick
    std::vector<sim::FlightEvent> events;
    std::vector<ShownFrame> frames;
    sim::VehicleState latest;
};

/// Writes a recording, batch by batch. Throws DatabaseError.
class RecordingWriter {
  public:
    /// Creates the file with its first heartbeat; `file` must not exist or be empty.
    RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header, const FlightChange& start);

    /// One transaction: all of the batch is in the file, or, after an exception, nothing; then it can be tried again.
    void write(const FlightBatch& batch);
    /// Says that the flight was closed properly after this tick.
    void finish(sim::Tick tick);

  private:
    /// Where the recording stands; restored when a transaction fails.
    struct Progress {
        Checksum controls;
        Checksum changes;
        std::int64_t change_count = 0;
        std::int64_t heartbeat_count = 0;
        std::int64_t event_count = 0;
    };

    void write_header(const RecordingHeader& header);
    void insert_demands(const std::vector<input::TimedControl>& demands);
    void insert_change(const FlightChange& change);
    void insert_event(const sim::FlightEvent& event);
    void insert_frames(const std::vector<ShownFrame>& frames);
    void insert_snapshot(const sim::VehicleState& state);
    void insert_heartbeat(const sim::VehicleState& state);

    RecordingLayout layout_ = present_layout();
    Database database_;
    Progress progress_;
    Statement insert_demands_;
    Statement insert_change_;
    Statement insert_snapshot_;
    Statement insert_event_;
    Statement insert_heartbeat_;
    std::optional<Statement> insert_frame_; ///< once a headset has shown something
};

} // namespace engine

#include "engine/recording_writer.h"

#include "engine/demand_code.h"
#include "sim/state_fields.h"
#include "sim/state_hash.h"

#include <bit>

namespace engine {
namespace {

/// SQLite's integers are signed; the bits are kept.
std::int64_t stored(std::uint64_t checksum) {
    return std::bit_cast<std::int64_t>(checksum);
}

std::int64_t stored_tick(sim::Tick tick) {
    return static_cast<std::int64_t>(tick);
}

std::string insert_into(const std::string& table, std::size_t columns) {
    return "INSERT INTO " + table + " VALUES (" + placeholders(columns) + ")";
}

/// A database with the tables of a recording, in a transaction that the caller completes.
Database begin_recording(const std::filesystem::path& file) {
    Database database = Database::create(file);
    database.execute("PRAGMA journal_mode = WAL");
    // A killed program loses nothing that was committed; only a power cut may lose what was not yet on the disk.
    database.execute("PRAGMA synchronous = NORMAL");
    database.execute("BEGIN IMMEDIATE");
    create_recording_tables(database);
    return database;
}

} // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header,
                                 const FlightChange& start)
    : database_(begin_recording(file)), insert_demands_(database_.prepare(insert_into("demands", 3))),
      insert_change_(database_.prepare(insert_into("changes", change_column_count()))),
      insert_snapshot_(database_.prepare(insert_into("snapshots", sim::state_fields.size() + 1))),
      insert_event_(database_.prepare(insert_into("events", 5))),
      insert_heartbeat_(database_.prepare(insert_into("heartbeats", 6))) {
    write_header(header);
    insert_change(start);
    insert_heartbeat(start.state);
    database_.execute("COMMIT");
}

void RecordingWriter::write_header(const RecordingHeader& header) {
    Statement insert = database_.prepare(insert_into("metadata", 3));
    const auto text = [&insert](std::string_view key, std::string_view value) {
        insert.bind(0, key).bind(1, value).bind(2, "").run();
    };
    text("program_version", header.program_version);
    text("started", header.started);
    text("scenario", header.scenario);
    text("scenario_name", header.scenario_name);
    text("title", header.title);
    text("scenario_text", header.scenario_text);
    text("clock_unit_name", header.clock_unit_name);
    text("origin", header.origin);
    insert.bind(0, "clock_unit_seconds").bind_exact(1, header.clock_unit_seconds).bind(2, "s").run();
    insert.bind(0, "pace").bind_exact(1, header.pace).bind(2, "clock units of ship time per second").run();
    insert.bind(0, "checksum").bind(1, stored(header.checksum())).bind(2, "").run();

    Statement insert_input = database_.prepare(insert_into("inputs", 3));
    for (const InputFile& input : header.inputs) {
        insert_input.bind(0, input.role).bind(1, input.file).bind(2, stored(input.checksum)).run();
    }
}

void RecordingWriter::write(const FlightBatch& batch) {
    if (database_.has_moved()) {
        throw DatabaseError("the file has been removed or renamed");
    }
    const Progress before = progress_;
    try {
        database_.execute("BEGIN IMMEDIATE");
        insert_demands(batch.controls);
        for (const FlightChange& change : batch.changes) {
            insert_change(change);
        }
        for (const sim::VehicleState& state : batch.snapshots) {
            insert_snapshot(state);
        }
        for (const sim::FlightEvent& event : batch.events) {
            insert_event(event);
        }
        insert_frames(batch.frames);
        insert_heartbeat(batch.latest);
        database_.execute("COMMIT");
    } catch (const DatabaseError&) {
        database_.roll_back();
        progress_ = before;
        throw;
    }
}

void RecordingWriter::insert_demands(const std::vector<input::TimedControl>& demands) {
    if (demands.empty()) {
        return;
    }
    insert_demands_.bind(0, stored_tick(demands.front().tick))
        .bind(1, static_cast<std::int64_t>(demands.size()))
        .bind_bytes(2, pack_demands(demands))
        .run();
    for (const input::TimedControl& timed : demands) {
        add(progress_.controls, timed, layout_);
    }
}

void RecordingWriter::insert_change(const FlightChange& change) {
    insert_change_.bind(0, progress_.change_count).bind(1, change.what).bind_exact(2, change.metres_per_light_unit);
    bind_state(insert_change_, bind_settings(insert_change_, 3, change.vehicle), change.state);
    insert_change_.run();
    add(progress_.changes, change, layout_);
    ++progress_.change_count;
}

void RecordingWriter::insert_snapshot(const sim::VehicleState& state) {
    const int next = bind_state(insert_snapshot_, 0, state);
    insert_snapshot_.bind(next, stored(sim::state_hash(state))).run();
}

void RecordingWriter::insert_event(const sim::FlightEvent& event) {
    insert_event_.bind(0, progress_.event_count)
        .bind(1, stored_tick(event.tick))
        .bind(2, sim::event_name(event.kind))
        .bind_exact(3, event.ship_clock.value)
        .bind_exact(4, event.world_clock.value)
        .run();
    ++progress_.event_count;
}

void RecordingWriter::insert_frames(const std::vector<ShownFrame>& frames) {
    if (frames.empty()) {
        return;
    }
    if (!insert_frame_) {
        create_frames_table(database_);
        insert_frame_.emplace(database_.prepare(insert_into("frames", 12)));
    }
    for (const ShownFrame& frame : frames) {
        insert_frame_->bind(0, stored_tick(frame.tick)).bind_exact(1, frame.fraction);
        const std::array<double, 16> numbers = numbers_of(frame.head);
        for (int i = 0; i < head_number_count; ++i) {
            insert_frame_->bind_exact(2 + i, numbers.at(static_cast<std::size_t>(first_head_number + i)));
        }
        insert_frame_->run();
    }
}

void RecordingWriter::insert_heartbeat(const sim::VehicleState& state) {
    insert_heartbeat_.bind(0, progress_.heartbeat_count)
        .bind(1, stored_tick(state.tick))
        .bind(2, progress_.change_count)
        .bind(3, stored(progress_.controls.sum()))
        .bind(4, stored(progress_.changes.sum()))
        .bind(5, stored(sim::state_hash(state)))
        .run();
    ++progress_.heartbeat_count;
}

void RecordingWriter::finish(sim::Tick tick) {
    database_.prepare(insert_into("ending", 1)).bind(0, stored_tick(tick)).run();
}

} // namespace engine

#include "engine/recording_file.h"

#include "engine/database.h"
#include "engine/demand_code.h"
#include "engine/older_demands.h"
#include "engine/recording_format.h"
#include "engine/recording_soundness.h"
#include "sim/bad_input.h"

#include <array>
#include <bit>
#include <fmt/format.h>
#include <fstream>

namespace engine {
namespace {

std::uint64_t read_checksum(const Statement& statement, int column) {
    return std::bit_cast<std::uint64_t>(statement.integer(column));
}

/// Throws unless the file looks like a database at all.
void expect_database(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        throw sim::BadInput(file.string(), "", "", "there is no such file");
    }
    std::array<char, 16> head{};
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", "cannot be opened for reading");
    }
    stream.read(head.data(), head.size());
    if (stream.gcount() == 0) {
        throw sim::BadInput(file.string(), "", "", "is empty, not a recording");
    }
    constexpr std::array<char, 16> magic{'S', 'Q', 'L', 'i', 't', 'e', ' ', 'f', 'o', 'r', 'm', 'a', 't', ' ', '3'};
    if (head != magic) {
        throw sim::BadInput(file.string(), "", "", "is not a recording of Rapidity");
    }
}

/// Returns the version.
std::int64_t expect_version(const std::filesystem::path& file, Database& database) {
    const std::int64_t application = database.integer("PRAGMA application_id");
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (application == 0 && version == 0 && database.integer("SELECT count(*) FROM sqlite_master") == 0) {
        throw sim::BadInput(file.string(), "", "", "holds no flight; was its -wal file left behind?");
    }
    if (application != recording_application_id) {
        throw sim::BadInput(file.string(), "", "", "is a database, but not a recording of Rapidity");
    }
    if (version > recording_format_version || version < oldest_recording_format_version) {
        throw sim::BadInput(
            file.string(), "format version", std::to_string(version),
            version > recording_format_version
                ? fmt::format("made by a newer Rapidity; this one reads versions up to {}", recording_format_version)
                : fmt::format("no such version; this Rapidity reads versions {} to {}", oldest_recording_format_version,
                              recording_format_version));
    }
    return version;
}

void expect_undamaged(Database& database) {
    Statement check = database.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok") {
        throw DatabaseError("the database is damaged");
    }
}

void read_header(Database& database, RecordingHeader& header) {
    Statement select = database.prepare("SELECT value FROM metadata WHERE key = ?");
    const auto has = [&select](std::string_view key) {
        select.reset();
        select.bind(0, key);
        return select.step();
    };
    const auto row = [&](std::string_view key) -> Statement& {
        if (!has(key)) {
            throw DatabaseError("the metadata " + std::string(key) + " is missing");
        }
        return select;
    };
    header.program_version = row("program_version").text(0);
    header.started = row("started").text(0);
    header.scenario = row("scenario").text(0);
    header.scenario_name = row("scenario_name").text(0);
    header.title = row("title").text(0);
    header.scenario_text = row("scenario_text").text(0);
    header.clock_unit_name = row("clock_unit_name").text(0);
    header.clock_unit_seconds = row("clock_unit_seconds").exact(0);
    header.pace = row("pace").exact(0);
    header.origin = has("origin") ? select.text(0) : "";
    const std::uint64_t checksum = read_checksum(row("checksum"), 0);

    Statement inputs = database.prepare("SELECT role, file, checksum FROM inputs ORDER BY rowid");
    while (inputs.step()) {
        header.inputs.push_back({inputs.text(0), inputs.text(1), read_checksum(inputs, 2)});
    }
    if (header.checksum() != checksum) {
        throw DatabaseError("its metadata do not match their checksum");
    }
}

void read_changes(Database& database, Recording& recording) {
    const RecordingLayout& layout = recording.layout;
    Statement select = database.prepare("SELECT id, what, metres_per_light_unit, " + settings_columns(layout) + ", " +
                                        state_columns(layout) + " FROM changes ORDER BY id");
    while (select.step()) {
        FlightChange change{select.text(1), {}, {}, select.exact(2)};
        read_state(select, read_settings(select, 3, layout, change.vehicle), layout, change.state);
        recording.changes.push_back(std::move(change));
    }
}

/// The demands of one row.
std::vector<input::TimedControl> read_pack(const Statement& row) {
    std::vector<input::TimedControl> pack = unpack_demands(row.bytes(2));
    if (pack.empty() || static_cast<std::int64_t>(pack.size()) != row.integer(1) ||
        pack.front().tick != read_tick(row, 0)) {
        throw DatabaseError("its demands are damaged");
    }
    return pack;
}

void read_demands(Database& database, Recording& recording) {
    std::vector<input::TimedControl>& demands = recording.controls;
    if (recording.layout.version < first_version_with_packs) {
        demands = read_older_demands(database);
        return;
    }
    Statement select = database.prepare("SELECT tick, count, packed FROM demands ORDER BY tick");
    while (select.step()) {
        const std::vector<input::TimedControl> pack = read_pack(select);
        if (!demands.empty() && demands.back().tick >= pack.front().tick) {
            throw DatabaseError("its demands are damaged");
        }
        demands.insert(demands.end(), pack.begin(), pack.end());
    }
}

void read_snapshot(const Statement& row, Recording& recording) {
    sim::VehicleState state;
    read_state(row, 1, recording.layout, state);
    recording.snapshot_hashes.push_back(read_checksum(row, 0));
    recording.snapshots.push_back(state);
}

std::string select_snapshots(const RecordingLayout& layout, const char* order) {
    return "SELECT state_hash, " + state_columns(layout) + " FROM snapshots ORDER BY tick " + order;
}

void read_snapshots(Database& database, Recording& recording) {
    Statement select = database.prepare(select_snapshots(recording.layout, "ASC"));
    while (select.step()) {
        read_snapshot(select, recording);
    }
}

void read_heartbeats(Database& database, Recording& recording) {
    std::vector<Heartbeat>& heartbeats = recording.heartbeats;
    Statement select = database.prepare("SELECT id, tick, changes, controls_checksum, changes_checksum, state_hash "
                                        "FROM heartbeats ORDER BY id");
    while (select.step()) {
        if (select.integer(0) != static_cast<std::int64_t>(heartbeats.size())) {
            throw DatabaseError("a heartbeat is missing");
        }
        heartbeats.push_back({read_tick(select, 1), static_cast<std::size_t>(select.integer(2)),
                              read_checksum(select, 5), read_checksum(select, 3), read_checksum(select, 4)});
    }
}

void read_events(Database& database, Recording& recording) {
    if (recording.layout.version < first_version_with_events) {
        return;
    }
    Statement select = database.prepare("SELECT tick, what, ship_clock, world_clock FROM events ORDER BY id");
    while (select.step()) {
        recording.events.push_back({read_tick(select, 0), select.text(1), sim::ProperTime(select.exact(2)),
                                    sim::CoordinateTime(select.exact(3))});
    }
}

void read_frames(Database& database, Recording& recording) {
    if (!database.prepare("SELECT 1 FROM sqlite_master WHERE name = 'frames'").step()) {
        return;
    }
    Statement select = database.prepare("SELECT * FROM frames ORDER BY rowid");
    while (select.step()) {
        std::array<double, 16> numbers{};
        for (int i = 0; i < head_number_count; ++i) {
            numbers.at(static_cast<std::size_t>(first_head_number + i)) = select.exact(2 + i);
        }
        recording.frames.push_back({read_tick(select, 0), select.exact(1), control_of(numbers, 0)});
    }
}

void read_all_bookmarks(Database& database, Recording& recording) {
    recording.bookmarks = read_bookmarks(database);
    for (Bookmark& bookmark : read_bookmarks_beside(recording.file)) {
        recording.bookmarks.push_back(std::move(bookmark));
    }
}

void read_ending(Database& database, Recording& recording) {
    Statement ending = database.prepare("SELECT tick FROM ending");
    if (ending.step()) {
        recording.ending = read_tick(ending, 0);
    }
}

// Rows behind a damaged one can be reached from the end alone. Each of these reads them from there, up to the damage or
// to what has been read from the start, whose order they then continue.

void read_later_demands(Database& database, Recording& recording) {
    std::vector<input::TimedControl>& demands = recording.controls;
    if (recording.layout.version < first_version_with_packs) {
        return; // tables for each part of a demand: a hole in one is a hole in all
    }
    std::vector<std::vector<input::TimedControl>> later;
    Statement select = database.prepare("SELECT tick, count, packed FROM demands ORDER BY tick DESC");
    try {
        while (select.step()) {
            std::vector<input::TimedControl> pack = read_pack(select);
            if ((!demands.empty() && pack.front().tick <= demands.back().tick) ||
                (!later.empty() && pack.back().tick >= later.back().front().tick)) {
                break;
            }
            later.push_back(std::move(pack));
        }
    } catch (const DatabaseError&) { // the hole's other side
    }
    for (auto pack = later.rbegin(); pack != later.rend(); ++pack) {
        demands.insert(demands.end(), pack->begin(), pack->end());
    }
}

void read_later_snapshots(Database& database, Recording& recording) {
    Recording later;
    later.layout = recording.layout;
    Statement select = database.prepare(select_snapshots(recording.layout, "DESC"));
    try {
        while (select.step()) {
            read_snapshot(select, later);
            const sim::Tick tick = later.snapshots.back().tick;
            if ((!recording.snapshots.empty() && tick <= recording.snapshots.back().tick) ||
                (later.snapshots.size() > 1 && tick >= later.snapshots[later.snapshots.size() - 2].tick)) {
                later.snapshots.pop_back();
                break;
            }
        }
    } catch (const DatabaseError&) { // the hole's other side
    }
    for (std::size_t i = later.snapshots.size(); i > 0; --i) {
        recording.snapshots.push_back(later.snapshots[i - 1]);
        recording.snapshot_hashes.push_back(later.snapshot_hashes[i - 1]);
    }
}

/// A part of a recording, and how it is read.
struct Part {
    const char* name;
    void (*read)(Database&, Recording&);
    void (*read_later)(Database&, Recording&) = nullptr; ///< what lies behind a damaged row
};

constexpr std::array<Part, 9> parts{{
    {"metadata", [](Database& database, Recording& recording) { read_header(database, recording.header); }},
    {"changes", read_changes},
    {"demands", read_demands, read_later_demands},
    {"snapshots", read_snapshots, read_later_snapshots},
    {"heartbeats", read_heartbeats},
    {"events", read_events},
    {"frames", read_frames},
    {"bookmarks", read_all_bookmarks},
    {"ending", read_ending},
}};

Recording read_tables(const std::filesystem::path& file) {
    Recording recording;
    recording.file = file;
    Database database = Database::open(file);
    database.execute("BEGIN"); // one moment of a recording that may still be growing
    recording.layout = read_layout(database, expect_version(file, database));
    expect_undamaged(database);
    for (const Part& part : parts) {
        part.read(database, recording);
    }
    if (recording.changes.empty() || recording.heartbeats.empty()) {
        throw DatabaseError("it holds no flight");
    }
    return recording;
}

} // namespace

std::uint64_t Recording::checksum() const {
    Checksum sum;
    sum.add(header.checksum());
    const Heartbeat& last = heartbeats.back();
    for (const std::uint64_t part : {last.tick, last.controls_checksum, last.changes_checksum, last.state_hash}) {
        sum.add(part);
    }
    return sum.sum();
}

Recording read_recording(const std::filesystem::path& file) {
    expect_database(file);
    try {
        Recording recording = read_tables(file);
        recording.damage = find_damage(recording);
        return recording;
    } catch (const DatabaseError& error) {
        throw sim::BadInput(file.string(), "", "", std::string("this recording cannot be read: ") + error.what());
    }
}

Recording read_remains(const std::filesystem::path& file, std::vector<std::string>& losses) {
    expect_database(file);
    Recording recording;
    recording.file = file;
    try {
        Database database = Database::open(file);
        database.execute("PRAGMA writable_schema = ON"); // reads a file that is shorter than it says
        recording.layout = read_layout(database, expect_version(file, database));
        for (const Part& part : parts) {
            try {
                part.read(database, recording);
            } catch (const DatabaseError& error) {
                losses.push_back(fmt::format("{}: {}", part.name, error.what()));
                if (part.read_later != nullptr) {
                    part.read_later(database, recording);
                }
            }
        }
    } catch (const DatabaseError& error) {
        throw sim::BadInput(file.string(), "", "", std::string("nothing of it can be read: ") + error.what());
    }
    if (recording.changes.empty()) {
        throw sim::BadInput(file.string(), "", "", "the start of the flight is lost; nothing can be flown from it");
    }
    return recording;
}

Recording read_sound_recording(const std::filesystem::path& file) {
    Recording recording = read_recording(file);
    if (recording.damage) {
        throw sim::BadInput(file.string(), "tick", std::to_string(recording.damage->tick), recording.damage->what);
    }
    return recording;
}

} // namespace engine

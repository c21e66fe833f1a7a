#include "engine/recording_file.h"

#include "engine/database.h"
#include "engine/recording_format.h"
#include "engine/recording_soundness.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>
#include <fstream>
#include <limits>

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

void expect_version(const std::filesystem::path& file, Database& database) {
    const std::int64_t application = database.integer("PRAGMA application_id");
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (application == 0 && version == 0 && database.integer("SELECT count(*) FROM sqlite_master") == 0) {
        throw sim::BadInput(file.string(), "", "", "holds no flight; was its -wal file left behind?");
    }
    if (application != recording_application_id) {
        throw sim::BadInput(file.string(), "", "", "is a database, but not a recording of Rapidity");
    }
    if (version != recording_format_version) {
        throw sim::BadInput(
            file.string(), "format version", std::to_string(version),
            version > recording_format_version
                ? fmt::format("made by a newer Rapidity; this one reads version {}", recording_format_version)
            : version > 0
                ? fmt::format("made by an older Rapidity, which flew a little differently; this one reads version {}",
                              recording_format_version)
                : "no such version");
    }
    Statement check = database.prepare("PRAGMA quick_check(1)");
    if (!check.step() || check.text(0) != "ok") {
        throw DatabaseError("the database is damaged");
    }
}

RecordingHeader read_header(Database& database, std::uint64_t& checksum) {
    Statement select = database.prepare("SELECT value FROM metadata WHERE key = ?");
    const auto row = [&select](std::string_view key) -> Statement& {
        select.reset();
        select.bind(0, key);
        if (!select.step()) {
            throw DatabaseError("the metadata " + std::string(key) + " is missing");
        }
        return select;
    };
    RecordingHeader header;
    header.program_version = row("program_version").text(0);
    header.started = row("started").text(0);
    header.scenario = row("scenario").text(0);
    header.scenario_name = row("scenario_name").text(0);
    header.title = row("title").text(0);
    header.scenario_text = row("scenario_text").text(0);
    header.clock_unit_name = row("clock_unit_name").text(0);
    header.clock_unit_seconds = row("clock_unit_seconds").exact(0);
    header.pace = row("pace").exact(0);
    checksum = read_checksum(row("checksum"), 0);

    Statement inputs = database.prepare("SELECT role, file, checksum FROM inputs ORDER BY rowid");
    while (inputs.step()) {
        header.inputs.push_back({inputs.text(0), inputs.text(1), read_checksum(inputs, 2)});
    }
    return header;
}

std::vector<FlightChange> read_changes(Database& database) {
    std::vector<FlightChange> changes;
    Statement select = database.prepare("SELECT id, what, metres_per_light_unit, " + settings_columns() + ", " +
                                        state_columns() + " FROM changes ORDER BY id");
    while (select.step()) {
        FlightChange change{select.text(1), {}, {}, select.exact(2)};
        read_state(select, read_settings(select, 3, change.vehicle), change.state);
        changes.push_back(std::move(change));
    }
    return changes;
}

/// The rows of one table that say what is demanded from a tick on.
class DemandRows {
  public:
    DemandRows(Database& database, const std::string& table)
        : rows_(database.prepare("SELECT * FROM " + table + " ORDER BY tick")) {
        next();
    }
    /// Of the present row; beyond every tick when there is none.
    sim::Tick tick() const { return tick_; }
    const Statement& row() const { return rows_; }
    void next() { tick_ = rows_.step() ? read_tick(rows_, 0) : std::numeric_limits<sim::Tick>::max(); }

  private:
    Statement rows_;
    sim::Tick tick_ = 0;
};

std::vector<input::TimedControl> read_controls(Database& database) {
    std::vector<DemandRows> groups;
    for (const ControlGroup& group : control_groups()) {
        groups.emplace_back(database, group.table);
    }
    DemandRows buttons(database, "buttons");

    std::vector<input::TimedControl> controls;
    auto numbers = numbers_of(sim::ControlFrame());
    std::uint32_t held = 0;
    while (true) {
        sim::Tick tick = buttons.tick();
        for (const DemandRows& group : groups) {
            tick = std::min(tick, group.tick());
        }
        if (tick == std::numeric_limits<sim::Tick>::max()) {
            return controls;
        }
        for (std::size_t g = 0; g < groups.size(); ++g) {
            if (groups[g].tick() == tick) {
                const ControlGroup& group = control_groups()[g];
                for (std::size_t i = 0; i < group.columns.size(); ++i) {
                    numbers[group.first + i] = groups[g].row().exact(static_cast<int>(i) + 1);
                }
                groups[g].next();
            }
        }
        if (buttons.tick() == tick) {
            held = static_cast<std::uint32_t>(buttons.row().integer(1));
            buttons.next();
        }
        controls.push_back({tick, control_of(numbers, held)});
    }
}

void read_snapshots(Database& database, Recording& recording) {
    Statement select = database.prepare("SELECT state_hash, " + state_columns() + " FROM snapshots ORDER BY tick");
    while (select.step()) {
        recording.snapshot_hashes.push_back(read_checksum(select, 0));
        read_state(select, 1, recording.snapshots.emplace_back());
    }
}

std::vector<Heartbeat> read_heartbeats(Database& database) {
    std::vector<Heartbeat> heartbeats;
    Statement select = database.prepare("SELECT id, tick, changes, controls_checksum, changes_checksum, state_hash "
                                        "FROM heartbeats ORDER BY id");
    while (select.step()) {
        if (select.integer(0) != static_cast<std::int64_t>(heartbeats.size())) {
            throw DatabaseError("a heartbeat is missing");
        }
        heartbeats.push_back({read_tick(select, 1), static_cast<std::size_t>(select.integer(2)),
                              read_checksum(select, 5), read_checksum(select, 3), read_checksum(select, 4)});
    }
    return heartbeats;
}

std::vector<RecordedEvent> read_events(Database& database) {
    std::vector<RecordedEvent> events;
    Statement select = database.prepare("SELECT tick, what, ship_clock, world_clock FROM events ORDER BY id");
    while (select.step()) {
        events.push_back({read_tick(select, 0), select.text(1), sim::ProperTime(select.exact(2)),
                          sim::CoordinateTime(select.exact(3))});
    }
    return events;
}

Recording read_tables(const std::filesystem::path& file) {
    Recording recording;
    recording.file = file;
    Database database = Database::open(file);
    database.execute("BEGIN"); // one moment of a recording that may still be growing
    expect_version(file, database);
    std::uint64_t header_checksum = 0;
    recording.header = read_header(database, header_checksum);
    recording.changes = read_changes(database);
    recording.controls = read_controls(database);
    read_snapshots(database, recording);
    recording.heartbeats = read_heartbeats(database);
    recording.events = read_events(database);
    Statement ending = database.prepare("SELECT tick FROM ending");
    if (ending.step()) {
        recording.ending = read_tick(ending, 0);
    }
    if (recording.changes.empty() || recording.heartbeats.empty()) {
        throw DatabaseError("it holds no flight");
    }
    if (recording.header.checksum() != header_checksum) {
        throw DatabaseError("its metadata do not match their checksum");
    }
    return recording;
}

} // namespace

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

Recording read_sound_recording(const std::filesystem::path& file) {
    Recording recording = read_recording(file);
    if (recording.damage) {
        throw sim::BadInput(file.string(), "tick", std::to_string(recording.damage->tick), recording.damage->what);
    }
    return recording;
}

} // namespace engine

#include "engine/recording_format.h"

#include "sim/snapshot.h"
#include "sim/state_hash.h"

#include <bit>
#include <fmt/format.h>
#include <numeric>
#include <set>
#include <string_view>

namespace engine {
namespace {

/// A number of the vehicle's settings: its column, and where it is.
struct SettingsField {
    std::string_view name;
    std::string_view unit;
    std::string_view meaning;
    double& (*in)(sim::VehicleSettings&);
};

constexpr std::array<SettingsField, 13> settings_fields{{
    {"maximum_acceleration_x", "c per clock unit", "largest proper acceleration along the vehicle's x",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_acceleration.x; }},
    {"maximum_acceleration_y", "c per clock unit", "along y",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_acceleration.y; }},
    {"maximum_acceleration_z", "c per clock unit", "along z",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_acceleration.z; }},
    {"maximum_turn_rate_x", "rad per clock unit", "largest turn rate about the vehicle's x",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_rate.x; }},
    {"maximum_turn_rate_y", "rad per clock unit", "about y",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_rate.y; }},
    {"maximum_turn_rate_z", "rad per clock unit", "about z",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_rate.z; }},
    {"boost_factor", "1", "factor on the largest acceleration while boost is held",
     [](sim::VehicleSettings& s) -> double& { return s.boost_factor; }},
    {"tick_rate", "1 per clock unit", "fixed steps per clock unit of ship time",
     [](sim::VehicleSettings& s) -> double& { return s.tick_rate; }},
    {"maximum_turn_acceleration_x", "rad per clock unit^2", "largest change of the turn rate about the vehicle's x",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_acceleration.x; }},
    {"maximum_turn_acceleration_y", "rad per clock unit^2", "about y",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_acceleration.y; }},
    {"maximum_turn_acceleration_z", "rad per clock unit^2", "about z",
     [](sim::VehicleSettings& s) -> double& { return s.maximum_turn_acceleration.z; }},
    {"propellant", "mass of the ship without it", "propellant at the start",
     [](sim::VehicleSettings& s) -> double& { return s.propellant; }},
    {"exhaust_speed", "c", "speed at which the propellant leaves the ship",
     [](sim::VehicleSettings& s) -> double& { return s.exhaust_speed; }},
}};

/// A column of some table, for the table `columns`.
struct ColumnNote {
    std::string_view table;
    std::string_view column;
    std::string_view unit;
    std::string_view meaning;
};

constexpr std::array<ColumnNote, 19> column_notes{{
    {"inputs", "checksum", "1", "of the file's bytes"},
    {"changes", "what", "", "one line"},
    {"changes", "metres_per_light_unit", "m", "scene metres in one light clock unit from here on"},
    {"demands", "tick", "tick", "first tick that the first demand of the row holds for"},
    {"demands", "count", "1", "demands in the row"},
    {"demands", "packed", "",
     "per demand: mask varint (1 next tick, 2 buttons, 4 << i number i), ticks since the last varint unless the next, "
     "numbers as bits XOR the last demand's (byte 16 z + n, n bytes, z zero bytes below) or as k 2^e (byte 9, e, k in "
     "two bytes; byte 10, k; byte 11, k and so all further ones without a byte before), buttons varint XOR the last; "
     "numbers in order: proper acceleration x, y, z in c per clock unit, angular velocity x, y, z in rad per clock "
     "unit, "
     "head position x, y, z in light clock units, vehicle_from_head w, x, y, z, head velocity x, y, z in c; buttons: "
     "1 boost, 2 brake, 4 undamped, 8 cruise, 16 autopilot, 32 motion is the target's; times 64: 1 hold heading, "
     "2 prograde, 3 retrograde, 4 target as seen, 5 target as it is now"},
    {"events", "tick", "tick", "after which it happened"},
    {"events", "what", "", "departure, flip, arrival, ..."},
    {"events", "ship_clock", "clock unit", "the ship's clock then"},
    {"events", "world_clock", "clock unit", "the world's clock then"},
    {"bookmarks", "tick", "tick", "that is marked"},
    {"bookmarks", "what", "", "one line"},
    {"snapshots", "state_hash", "1", "of the state in the same row"},
    {"heartbeats", "tick", "tick", "ticks flown when this was committed"},
    {"heartbeats", "changes", "1", "rows of changes so far"},
    {"heartbeats", "controls_checksum", "1", "of all demands so far"},
    {"heartbeats", "changes_checksum", "1", "of all changes so far"},
    {"heartbeats", "state_hash", "1", "of the state after that tick"},
    {"ending", "tick", "tick", "last tick of a flight that was closed properly"},
}};

void note_column(Statement& insert, const ColumnNote& note) {
    insert.bind(0, note.table).bind(1, note.column).bind(2, note.unit).bind(3, note.meaning).run();
}

void note_columns(Database& database) {
    Statement insert = database.prepare("INSERT INTO columns VALUES (?, ?, ?, ?)");
    for (const ColumnNote& note : column_notes) {
        note_column(insert, note);
    }
    for (const SettingsField& field : settings_fields) {
        note_column(insert, {"changes", field.name, field.unit, field.meaning});
    }
    for (const sim::StateField& field : sim::state_fields) {
        note_column(insert, {"changes", field.name, field.unit, field.doc});
        note_column(insert, {"snapshots", field.name, field.unit, field.doc});
    }
}

} // namespace

std::array<double, 16> numbers_of(const sim::ControlFrame& c) {
    const glm::dvec3& a = c.proper_acceleration;
    const glm::dvec3& w = c.angular_velocity;
    const glm::dvec3& p = c.head_position;
    const glm::dquat& q = c.vehicle_from_head;
    const glm::dvec3& v = c.head_velocity;
    return {a.x, a.y, a.z, w.x, w.y, w.z, p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z};
}

sim::ControlFrame control_of(const std::array<double, 16>& n, std::uint32_t buttons) {
    return {{n[0], n[1], n[2]},    {n[3], n[4], n[5]},
            {n[6], n[7], n[8]},    glm::dquat(n[9], n[10], n[11], n[12]),
            {n[13], n[14], n[15]}, buttons};
}

bool identical(const sim::ControlFrame& a, const sim::ControlFrame& b) {
    using Bits = std::array<std::uint64_t, 16>;
    return a.buttons == b.buttons && std::bit_cast<Bits>(numbers_of(a)) == std::bit_cast<Bits>(numbers_of(b));
}

RecordingLayout present_layout() {
    RecordingLayout layout;
    layout.state.resize(sim::state_fields.size());
    std::iota(layout.state.begin(), layout.state.end(), std::size_t{0});
    layout.settings.resize(settings_fields.size());
    std::iota(layout.settings.begin(), layout.settings.end(), std::size_t{0});
    return layout;
}

RecordingLayout read_layout(Database& database, std::int64_t version) {
    std::set<std::string, std::less<>> there;
    Statement columns = database.prepare("PRAGMA table_info(changes)");
    constexpr int name_column = 1;
    while (columns.step()) {
        there.insert(columns.text(name_column));
    }
    RecordingLayout layout;
    layout.version = version;
    for (std::size_t i = 0; i < sim::state_fields.size(); ++i) {
        if (there.contains(sim::state_fields[i].name)) {
            layout.state.push_back(i);
        }
    }
    for (std::size_t i = 0; i < settings_fields.size(); ++i) {
        if (there.contains(settings_fields[i].name)) {
            layout.settings.push_back(i);
        }
    }
    if (layout.state.empty() || layout.settings.empty()) {
        throw DatabaseError("the database lacks what a recording has");
    }
    return layout;
}

std::uint64_t RecordingLayout::hash(const sim::VehicleState& state_of_flight) const {
    return sim::state_hash(state_of_flight, state);
}

std::string state_columns(const RecordingLayout& layout) {
    std::vector<std::string_view> names;
    for (const std::size_t field : layout.state) {
        names.push_back(sim::state_fields.at(field).name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string settings_columns(const RecordingLayout& layout) {
    std::vector<std::string_view> names;
    for (const std::size_t field : layout.settings) {
        names.push_back(settings_fields.at(field).name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::size_t change_column_count() {
    return 3 + settings_fields.size() + sim::state_fields.size();
}

int bind_state(Statement& statement, int next, const sim::VehicleState& state) {
    for (const double value : sim::snapshot(state)) {
        statement.bind_exact(next++, value);
    }
    return next;
}

int read_state(const Statement& statement, int next, const RecordingLayout& layout, sim::VehicleState& state) {
    sim::Snapshot values = sim::snapshot({});
    for (const std::size_t field : layout.state) {
        const bool is_tick = sim::state_fields.at(field).name == "tick";
        values.at(field) = is_tick ? static_cast<double>(read_tick(statement, next)) : statement.exact(next);
        ++next;
    }
    state = sim::restore(values);
    return next;
}

sim::Tick read_tick(const Statement& statement, int column) {
    const std::int64_t tick = statement.integer(column);
    if (tick < 0 || static_cast<sim::Tick>(tick) > largest_tick) {
        throw DatabaseError("a tick is out of range");
    }
    return static_cast<sim::Tick>(tick);
}

int bind_settings(Statement& statement, int next, const sim::VehicleSettings& settings) {
    sim::VehicleSettings copy = settings;
    for (const SettingsField& field : settings_fields) {
        statement.bind_exact(next++, field.in(copy));
    }
    return next;
}

int read_settings(const Statement& statement, int next, const RecordingLayout& layout, sim::VehicleSettings& settings) {
    for (const std::size_t field : layout.settings) {
        settings_fields.at(field).in(settings) = statement.exact(next++);
    }
    return next;
}

void add(Checksum& checksum, const input::TimedControl& timed, const RecordingLayout& layout) {
    const auto numbers = numbers_of(timed.control);
    checksum.add(timed.tick);
    if (layout.version < first_version_with_packs) {
        const std::size_t number_count = layout.version < first_version_with_events ? 13 : 16; // all that there were
        for (std::size_t i = 0; i < number_count; ++i) {
            checksum.add(numbers.at(i));
        }
    } else { // only what is demanded, so that numbers that are added later change no sum
        const auto nothing = numbers_of({});
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (std::bit_cast<std::uint64_t>(numbers[i]) != std::bit_cast<std::uint64_t>(nothing[i])) {
                checksum.add(std::uint64_t{i});
                checksum.add(numbers[i]);
            }
        }
    }
    checksum.add(std::uint64_t{timed.control.buttons});
}

void add(Checksum& checksum, const FlightChange& change, const RecordingLayout& layout) {
    checksum.add(change.what);
    checksum.add(change.metres_per_light_unit);
    sim::VehicleSettings settings = change.vehicle;
    for (const std::size_t field : layout.settings) {
        checksum.add(settings_fields.at(field).in(settings));
    }
    checksum.add(layout.hash(change.state));
}

std::string placeholders(std::size_t count) {
    std::string marks;
    for (std::size_t i = 0; i < count; ++i) {
        marks += i == 0 ? "?" : ", ?";
    }
    return marks;
}

void create_frames_table(Database& database) {
    if (database.prepare("SELECT 1 FROM sqlite_master WHERE name = 'frames'").step()) {
        return;
    }
    database.execute("CREATE TABLE frames (tick INTEGER, fraction, head_x, head_y, head_z, vehicle_from_head_w, "
                     "vehicle_from_head_x, vehicle_from_head_y, vehicle_from_head_z, head_velocity_x, head_velocity_y, "
                     "head_velocity_z)");
    Statement insert = database.prepare("INSERT INTO columns VALUES (?, ?, ?, ?)");
    note_column(insert, {"frames", "tick", "tick", "last that was flown before the frame"});
    note_column(insert, {"frames", "fraction", "1", "of that tick that had passed"});
    for (const char* axis : {"x", "y", "z"}) {
        note_column(insert, {"frames", std::string("head_") + axis, "light clock unit", "head's place in the vehicle"});
        note_column(insert, {"frames", std::string("head_velocity_") + axis, "c", "of the head in the vehicle"});
    }
    for (const char* part : {"w", "x", "y", "z"}) {
        note_column(insert, {"frames", std::string("vehicle_from_head_") + part, "1", "quaternion"});
    }
}

void create_recording_tables(Database& database) {
    const RecordingLayout layout = present_layout();
    const std::string state = state_columns(layout);
    database.execute("PRAGMA application_id = " + std::to_string(recording_application_id));
    database.execute("PRAGMA user_version = " + std::to_string(recording_format_version));
    database.execute("CREATE TABLE metadata (key TEXT PRIMARY KEY, value, unit TEXT)");
    database.execute("CREATE TABLE inputs (role TEXT PRIMARY KEY, file TEXT, checksum)");
    database.execute("CREATE TABLE changes (id INTEGER PRIMARY KEY, what TEXT, metres_per_light_unit, " +
                     settings_columns(layout) + ", " + state + ")");
    database.execute("CREATE TABLE demands (tick INTEGER PRIMARY KEY, count INTEGER, packed BLOB)");
    constexpr std::string_view key = "tick"; // the first of the state's fields
    database.execute("CREATE TABLE snapshots (tick INTEGER PRIMARY KEY" + state.substr(key.size()) + ", state_hash)");
    database.execute("CREATE TABLE heartbeats (id INTEGER PRIMARY KEY, tick, changes, controls_checksum, "
                     "changes_checksum, state_hash)");
    database.execute("CREATE TABLE events (id INTEGER PRIMARY KEY, tick INTEGER, what TEXT, ship_clock, world_clock)");
    database.execute(bookmarks_table);
    database.execute("CREATE TABLE ending (tick)");
    database.execute("CREATE TABLE columns (table_name TEXT, column_name TEXT, unit TEXT, meaning TEXT)");
    note_columns(database);
}

} // namespace engine

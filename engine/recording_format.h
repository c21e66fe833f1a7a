#pragma once

#include "engine/checksum.h"
#include "engine/database.h"
#include "engine/tick_sink.h"
#include "input/replay_pilot.h"
#include "sim/vehicle.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// What a recording file looks like; the writer and the reader both go by this page. An SQLite database in WAL mode:
///   metadata    key, value, unit: program, scenario and its full text, clock; covered by the row "checksum"
///   inputs      the files that the scenario was made of, with the checksum of their bytes
///   changes     the start (id 0) and every later change of state or settings by something other than a tick
///   demands     the ControlFrames, a row for each commit in which they changed: its first tick, how many there are,
///   and
///               the demands as engine/demand_code.h packs them; each holds from its tick until the next one's
///   snapshots   the full state and its hash after every 240th tick
///   events      departures, flips and arrivals with both clocks; they follow from the flight, so no checksum covers
///               them
///   frames      only of a flight in a headset: the head that each picture was drawn for, between the ticks' heads; no
///               checksum covers them
///   bookmarks   moments marked by those who watched the flight; no part of it, so no checksum covers them
///   heartbeats  at every commit: ticks so far, checksums of all demands and changes so far, hash of the state
///   ending      the last tick; one row, written when the flight was closed properly
///   columns     unit and meaning of every column above
/// Ticks are the state's: a demand's tick is the one before the step, a snapshot's the one after it. Numbers are in
/// columns without a declared type and keep every bit (Statement::bind_exact).
///
/// Older versions are read as they are (RecordingLayout); what they lack is as in a fresh object. Versions 1 and 2 flew
/// a little differently; version 5 wrote demands without short numbers; versions 1 to 5 have no bookmarks until one is
/// kept. Until version 4 the tables thrust, turn, head and buttons held the demands, a row for each
/// tick at which its part of them changed.
namespace engine {

inline constexpr std::int64_t recording_application_id = 0x52504459; ///< "RPDY"
inline constexpr std::int64_t recording_format_version = 6;
inline constexpr std::int64_t oldest_recording_format_version = 1;
inline constexpr std::int64_t first_version_with_events = 4;
inline constexpr std::int64_t first_version_with_packs = 5;
/// One second of flight at the usual 240 ticks per clock unit of one second.
inline constexpr sim::Tick snapshot_interval = 240;

/// Of numbers_of(): where the head's begin, and how many there are.
inline constexpr int first_head_number = 6;
inline constexpr int head_number_count = 10;

/// One ControlFrame as numbers in a fixed order, for storing and for comparing bit by bit.
std::array<double, 16> numbers_of(const sim::ControlFrame& control);
sim::ControlFrame control_of(const std::array<double, 16>& numbers, std::uint32_t buttons);
/// Bit by bit: 0 and -0 differ, as the states that they lead to do.
bool identical(const sim::ControlFrame& a, const sim::ControlFrame& b);

/// What there is of a state and of the settings in a recording, in the order of this program's tables of fields. Its
/// hashes and checksums cover just that.
struct RecordingLayout {
    std::int64_t version = recording_format_version;
    std::vector<std::size_t> state;    ///< numbers in sim::state_fields
    std::vector<std::size_t> settings; ///< numbers in the table of the settings' fields

    std::uint64_t hash(const sim::VehicleState& state_of_flight) const;
};
/// Of the recordings that this program writes: everything.
RecordingLayout present_layout();
/// Of an open recording, whose version is known.
RecordingLayout read_layout(Database& database, std::int64_t version);

/// Names of the columns that bind_state / bind_settings fill and read_state / read_settings read, comma-separated.
std::string state_columns(const RecordingLayout& layout);
std::string settings_columns(const RecordingLayout& layout);
std::size_t change_column_count();
/// Each returns the number of the next parameter or column.
int bind_state(Statement& statement, int first, const sim::VehicleState& state);
int bind_settings(Statement& statement, int first, const sim::VehicleSettings& settings);
int read_state(const Statement& statement, int first, const RecordingLayout& layout, sim::VehicleState& state);
int read_settings(const Statement& statement, int first, const RecordingLayout& layout, sim::VehicleSettings& settings);

/// The largest tick that is exact as a double: a million years at 240 Hz.
inline constexpr sim::Tick largest_tick = sim::Tick{1} << 53u;
/// A tick that came from outside the program: 0 to largest_tick. Throws DatabaseError.
sim::Tick read_tick(const Statement& statement, int column);

void add(Checksum& checksum, const input::TimedControl& control, const RecordingLayout& layout);
void add(Checksum& checksum, const FlightChange& change, const RecordingLayout& layout);

/// Makes the table of bookmarks where there is none.
inline constexpr const char* bookmarks_table =
    "CREATE TABLE IF NOT EXISTS bookmarks (id INTEGER PRIMARY KEY, tick INTEGER, what TEXT)";

/// Creates the empty tables of a new recording.
void create_recording_tables(Database& database);

/// Adds the table of a headset's frames, where there is none.
void create_frames_table(Database& database);

/// "?, ?, ..." for an INSERT.
std::string placeholders(std::size_t count);

} // namespace engine

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
///   thrust, turn, head, buttons
///               the ControlFrame by groups: a row says what is demanded from this tick on; no row, no change
///   snapshots   the full state and its hash after every 240th tick
///   events      departures, flips and arrivals with both clocks; they follow from the flight, so no checksum covers
///   them heartbeats  at every commit: ticks so far, checksums of all demands and changes so far, hash of the state
///   ending      the last tick; one row, written when the flight was closed properly
///   columns     unit and meaning of every column above
/// Ticks are the state's: a demand's tick is the one before the step, a snapshot's the one after it. Numbers are in
/// columns without a declared type and keep every bit (Statement::bind_exact).
namespace engine {

inline constexpr std::int64_t recording_application_id = 0x52504459; ///< "RPDY"
inline constexpr std::int64_t recording_format_version = 4;
/// One second of flight at the usual 240 ticks per clock unit of one second.
inline constexpr sim::Tick snapshot_interval = 240;

/// One ControlFrame as numbers in a fixed order, for storing and for comparing bit by bit.
std::array<double, 16> numbers_of(const sim::ControlFrame& control);
sim::ControlFrame control_of(const std::array<double, 16>& numbers, std::uint32_t buttons);
/// Bit by bit: 0 and -0 differ, as the states that they lead to do.
bool identical(const sim::ControlFrame& a, const sim::ControlFrame& b);

/// The part of numbers_of() that one table keeps.
struct ControlGroup {
    const char* table;
    std::vector<const char*> columns;
    std::size_t first; ///< in numbers_of()
};
const std::array<ControlGroup, 3>& control_groups();

/// Names of the columns that bind_state / bind_settings fill and read_state / read_settings read, comma-separated.
std::string state_columns();
std::string settings_columns();
std::size_t change_column_count();
/// Each returns the number of the next parameter or column.
int bind_state(Statement& statement, int first, const sim::VehicleState& state);
int bind_settings(Statement& statement, int first, const sim::VehicleSettings& settings);
int read_state(const Statement& statement, int first, sim::VehicleState& state);
int read_settings(const Statement& statement, int first, sim::VehicleSettings& settings);

/// A tick that came from outside the program: 0 to 2^53. Throws DatabaseError.
sim::Tick read_tick(const Statement& statement, int column);

void add(Checksum& checksum, const input::TimedControl& control);
void add(Checksum& checksum, const FlightChange& change);

/// Creates the empty tables of a new recording.
void create_recording_tables(Database& database);

/// "?, ?, ..." for an INSERT.
std::string placeholders(std::size_t count);

} // namespace engine

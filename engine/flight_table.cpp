#include "engine/flight_table.h"

#include "engine/flight_columns.h"
#include "engine/hud/readouts.h"
#include "engine/option_values.h"
#include "engine/replay_deck.h"
#include "sim/bad_input.h"
#include "sim/readings.h"
#include "sim/retarded.h"
#include "sim/state_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <string_view>

namespace engine {
namespace {

/// A flight at one moment, as the columns see it.
struct Row {
    sim::VehicleState state;
    sim::ControlFrame demand;
    sim::Readings shown;
    double position = 0.0;           ///< ticks
    double speed_of_light = 1.0;     ///< metres per second
    double clock_unit_seconds = 1.0; ///< seconds
    glm::dvec3 start{0.0};           ///< where the flight began, light clock units
};

struct Column {
    std::string name;
    std::string unit;
    std::string meaning;
    std::function<double(const Row&)> of;
    bool usual = true; ///< written unless others are asked for
};

void add_tetrad(std::vector<Column>& columns) {
    const std::vector<std::string> names = flight_columns();
    constexpr std::size_t first = 5; // after tau and the event, which the state's fields are
    for (std::size_t i = first; i < names.size(); ++i) {
        columns.push_back({names[i], "1", "tetrad: the vehicle's time, right, up and back in the world",
                           [i](const Row& row) { return flight_values(row.state).at(i); }, false});
    }
    for (std::size_t i = 0; i < 4; ++i) {
        columns.push_back({fmt::format("u{}", names.at(first + i).substr(2)), "1", "four-velocity in the world",
                           [i](const Row& row) { return flight_values(row.state).at(first + i); }, false});
    }
}

void add_demands(std::vector<Column>& columns) {
    static constexpr std::array axes{"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        columns.push_back({fmt::format("demanded_acceleration_{}", axes.at(static_cast<std::size_t>(i))),
                           std::string(sim::unit_acceleration), "what the pilot demanded, vehicle axes",
                           [i](const Row& row) { return row.demand.proper_acceleration[i]; }, false});
    }
    for (int i = 0; i < 3; ++i) {
        columns.push_back({fmt::format("demanded_turn_rate_{}", axes.at(static_cast<std::size_t>(i))),
                           std::string(sim::unit_turn_rate), "what the pilot demanded, vehicle axes",
                           [i](const Row& row) { return row.demand.angular_velocity[i]; }, false});
    }
    for (int i = 0; i < 3; ++i) {
        columns.push_back({fmt::format("head_position_{}", axes.at(static_cast<std::size_t>(i))),
                           std::string(sim::unit_length), "head in the vehicle",
                           [i](const Row& row) { return row.demand.head_position[i]; }, false});
    }
    const auto turn = [&columns](const char* name, auto of) {
        columns.push_back({name, "1", "vehicle_from_head, unit quaternion", of, false});
    };
    turn("head_qw", [](const Row& row) { return row.demand.vehicle_from_head.w; });
    turn("head_qx", [](const Row& row) { return row.demand.vehicle_from_head.x; });
    turn("head_qy", [](const Row& row) { return row.demand.vehicle_from_head.y; });
    turn("head_qz", [](const Row& row) { return row.demand.vehicle_from_head.z; });
    columns.push_back({"buttons", "bits", "as in the recording's table of columns",
                       [](const Row& row) { return static_cast<double>(row.demand.buttons); }, false});
}

/// Every column that there is, in the order they are listed.
std::vector<Column> all_columns() {
    std::vector<Column> columns;
    columns.reserve(2 * std::size(sim::state_fields));
    for (const sim::StateField& field : sim::state_fields) {
        columns.push_back({std::string(field.name), std::string(field.unit), std::string(field.doc),
                           [get = field.get](const Row& row) { return get(row.state); }});
    }
    columns.front().of = [](const Row& row) { return row.position; }; // between two ticks, part of the next
    const auto shown = [&columns](const char* name, const char* unit, const char* meaning, auto of) {
        columns.push_back({name, unit, meaning, of});
    };
    shown("beta", "1", "speed in the world", [](const Row& row) { return row.shown.beta; });
    shown("gamma", "1", "1 / sqrt(1 - beta^2)", [](const Row& row) { return row.shown.gamma; });
    shown("rapidity", "1", "atanh beta", [](const Row& row) { return row.shown.rapidity.value; });
    shown("felt_acceleration", "c/clock unit", "magnitude of the proper acceleration",
          [](const Row& row) { return row.shown.felt_acceleration; });
    columns.push_back({"felt_g", "g", "felt_acceleration in 9.80665 m/s^2",
                       [](const Row& row) {
                           return g_from_acceleration(row.shown.felt_acceleration, row.speed_of_light,
                                                      row.clock_unit_seconds);
                       },
                       false});
    columns.push_back({"start_clock_seen", "clock unit",
                       "what is read, from the ship, on a clock at rest where the flight began",
                       [](const Row& row) {
                           return sim::retarded_emission({row.start, glm::dvec3(0.0)}, row.state.event).event.t;
                       },
                       false});
    add_tetrad(columns);
    add_demands(columns);
    return columns;
}

std::vector<Column> chosen_columns(const std::vector<std::string>& names) {
    std::vector<Column> all = all_columns();
    std::vector<Column> chosen;
    if (names.empty()) {
        std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [](const Column& c) { return c.usual; });
        return chosen;
    }
    for (const std::string& name : names) {
        const auto found =
            std::find_if(all.begin(), all.end(), [&name](const Column& column) { return column.name == name; });
        if (found == all.end()) {
            std::vector<std::string_view> known;
            known.reserve(all.size());
            for (const Column& column : all) {
                known.emplace_back(column.name);
            }
            refuse_name("--columns", name, known);
        }
        chosen.push_back(*found);
    }
    return chosen;
}

std::string csv_header(const std::vector<Column>& columns) {
    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const Column& column : columns) {
        names.push_back(fmt::format("{} [{}]", column.name, column.unit));
    }
    return fmt::format("{}\n", fmt::join(names, ","));
}

std::string header(const Recording& recording, const std::vector<Column>& columns, TableFormat format) {
    if (format == TableFormat::csv) {
        return csv_header(columns);
    }
    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const Column& column : columns) {
        names.push_back(fmt::format(R"({{"name": "{}", "unit": "{}", "meaning": "{}"}})", column.name, column.unit,
                                    column.meaning));
    }
    return fmt::format("{{\"recording\": \"{:016x}\",\n\"columns\": [\n{}\n],\n\"rows\": [", recording.checksum(),
                       fmt::join(names, ",\n"));
}

std::string line(const std::vector<Column>& columns, const Row& row, TableFormat format) {
    std::vector<std::string> values;
    for (const Column& column : columns) {
        const double value = column.of(row);
        // JSON has no infinities.
        values.push_back(format == TableFormat::json && !std::isfinite(value) ? "null" : fmt::format("{}", value));
    }
    return format == TableFormat::csv ? fmt::format("{}\n", fmt::join(values, ","))
                                      : fmt::format("[{}]", fmt::join(values, ", "));
}

} // namespace

void write_flight_table(const Recording& recording, const TableRequest& request, const std::filesystem::path& file) {
    const std::vector<Column> columns = chosen_columns(request.columns);
    ReplayDeck deck(recording);
    Row row;
    row.clock_unit_seconds = recording.header.clock_unit_seconds;
    row.start = recording.changes.front().state.event.space;
    std::ofstream stream(file);
    stream << header(recording, columns, request.format);
    const auto first = static_cast<double>(deck.first());
    const auto end = static_cast<double>(deck.end());
    for (std::size_t i = 0; row.position < end || i == 0; ++i) {
        row.position = std::min(first + static_cast<double>(i) * request.ticks_per_row, end);
        deck.seek(row.position);
        row.state = deck.state();
        row.demand = deck.moment().control;
        row.shown = sim::readings(row.state);
        row.speed_of_light = deck.moment().metres_per_light_unit / row.clock_unit_seconds;
        stream << (request.format == TableFormat::json ? (i == 0 ? "\n" : ",\n") : "")
               << line(columns, row, request.format);
    }
    stream << (request.format == TableFormat::json ? "\n]}\n" : "");
    stream.close();
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", "cannot be written");
    }
}

std::string flight_table_header() {
    return csv_header(chosen_columns({}));
}

std::string flight_table_row(const sim::VehicleState& state) {
    static const std::vector<Column> usual = chosen_columns({});
    Row row;
    row.state = state;
    row.shown = sim::readings(state);
    row.position = static_cast<double>(state.tick);
    return line(usual, row, TableFormat::csv);
}

std::vector<std::string> table_columns() {
    std::vector<std::string> lines;
    for (const Column& column : all_columns()) {
        lines.push_back(fmt::format("{:28} {:18} {}{}", column.name, column.unit, column.meaning,
                                    column.usual ? "" : " (only when asked for)"));
    }
    return lines;
}

} // namespace engine

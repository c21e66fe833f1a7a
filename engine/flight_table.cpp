#include "engine/flight_table.h"

#include "engine/replay_check.h"
#include "sim/bad_input.h"
#include "sim/readings.h"
#include "sim/snapshot.h"

#include <array>
#include <fmt/format.h>
#include <fstream>
#include <string_view>

namespace engine {
namespace {

/// A column that follows from the state.
struct DerivedColumn {
    std::string_view name;
    std::string_view unit;
    double (*of)(const sim::Readings&);
};

constexpr std::array derived_columns{
    DerivedColumn{"beta", "1", [](const sim::Readings& r) { return r.beta; }},
    DerivedColumn{"gamma", "1", [](const sim::Readings& r) { return r.gamma; }},
    DerivedColumn{"rapidity", "1", [](const sim::Readings& r) { return r.rapidity.value; }},
    DerivedColumn{"felt_acceleration", "c/clock unit", [](const sim::Readings& r) { return r.felt_acceleration; }},
    DerivedColumn{"wavelength_ratio_ahead", "1", [](const sim::Readings& r) { return r.wavelength_ratio_ahead; }},
};

} // namespace

std::string flight_table_header() {
    std::string line;
    for (const sim::StateField& field : sim::state_fields) {
        line += fmt::format("{}{} [{}]", line.empty() ? "" : ",", field.name, field.unit);
    }
    for (const DerivedColumn& column : derived_columns) {
        line += fmt::format(",{} [{}]", column.name, column.unit);
    }
    return line + "\n";
}

std::string flight_table_row(const sim::VehicleState& state) {
    std::string line;
    for (const double value : sim::snapshot(state)) {
        line += fmt::format("{}{}", line.empty() ? "" : ",", value);
    }
    const sim::Readings shown = sim::readings(state);
    for (const DerivedColumn& column : derived_columns) {
        line += fmt::format(",{}", column.of(shown));
    }
    return line + "\n";
}

void write_flight_table(const Recording& recording, sim::Tick every, const std::filesystem::path& file) {
    std::ofstream stream(file);
    stream << flight_table_header();
    fly_again(recording, [&](const sim::VehicleState& state) {
        if ((state.tick - recording.first_tick()) % every == 0 || state.tick == recording.end()) {
            stream << flight_table_row(state);
        }
    });
    stream.close();
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", "cannot be written");
    }
}

} // namespace engine

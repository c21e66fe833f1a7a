#include "content/flight_script.h"

#include "content/csv.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>

namespace content {
namespace {

constexpr std::array<std::string_view, 7> columns{"duration", "ax", "ay", "az", "wx", "wy", "wz"};

void refuse_unknown_columns(const CsvTable& table) {
    for (const std::string& name : table.header) {
        if (std::ranges::find(columns, name) == columns.end()) {
            throw sim::BadInput(table.source, "column", name,
                                fmt::format("unknown; a flight script has {}", fmt::join(columns, ",")));
        }
        if (std::ranges::count(table.header, name) > 1) {
            throw sim::BadInput(table.source, "column", name, "stands there twice");
        }
    }
}

} // namespace

sim::FlightScript load_flight_script(const std::filesystem::path& file) {
    const CsvTable table = read_csv(file);
    refuse_unknown_columns(table);
    std::array<std::size_t, columns.size()> at{};
    std::ranges::transform(columns, at.begin(), [&](std::string_view name) { return table.column(std::string(name)); });
    if (table.rows.empty()) {
        throw sim::BadInput(table.source, "", "", "no rows; a flight script needs at least one");
    }

    sim::FlightScript script;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto value = [&](std::size_t column) { return table.number(row, at[column]); };
        if (value(0) <= 0.0) {
            throw sim::BadInput(table.source, fmt::format("line {}, duration", table.line_numbers[row]),
                                table.rows[row][at[0]], "must be above 0");
        }
        script.push_back({sim::ProperTime(value(0)), {value(1), value(2), value(3)}, {value(4), value(5), value(6)}});
    }
    return script;
}

} // namespace content

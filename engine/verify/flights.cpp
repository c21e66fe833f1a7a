#include "engine/verify/flights.h"

#include "engine/verify/truth_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

/// flights.csv: segments of constant thrust and turn, chained per flight from rest at the origin.
namespace engine {
namespace {

constexpr double default_rate = 240.0;

ComputedRows fly(const content::CsvTable& table, double rate) {
    ComputedRows computed;
    for (const TrueFlight& flight : read_true_flights(table)) {
        sim::VehicleState state;
        for (const sim::FlightSegment& segment : flight.script) {
            state = sim::fly_segment(state, segment, rate);
            const auto values = flight_values(state);
            computed.emplace_back(values.begin(), values.end());
        }
    }
    return computed;
}

/// The largest error at one rate over the rows that are not down to their rounding at the highest.
double largest_error(const content::CsvTable& table, double rate) {
    double largest = 0.0;
    for (const RowError& error : compare(flights_truth_table(), table, fly(table, rate))) {
        if (error.rounding < flights_truth_table().tolerance) {
            largest = std::max(largest, error.relative_error);
        }
    }
    return largest;
}

std::vector<std::string> order_of_convergence(const content::CsvTable& table) {
    std::vector<std::string> lines;
    double coarser = 0.0;
    for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
        const double error = largest_error(table, rate);
        std::string line = fmt::format("{:4.0f} Hz: largest error {:.2e}", rate, error);
        if (coarser > 0.0 && error > 0.0) {
            line += fmt::format(", order {:.2f}", std::log2(coarser / error));
        }
        lines.push_back(line);
        coarser = error;
    }
    return lines;
}

} // namespace

std::vector<TrueFlight> read_true_flights(const content::CsvTable& table) {
    const std::size_t name = table.column("flight");
    const std::size_t duration = table.column("duration");
    std::array<std::size_t, 6> drive{};
    std::ranges::transform(std::array{"ax", "ay", "az", "wx", "wy", "wz"}, drive.begin(),
                           [&](const char* column) { return table.column(column); });
    std::array<std::size_t, flight_column_count> end{};
    std::ranges::transform(flight_columns(), end.begin(),
                           [&](const std::string& column) { return table.column(column); });

    std::vector<TrueFlight> flights;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (flights.empty() || table.rows[row][name] != flights.back().name) {
            flights.push_back({table.rows[row][name], {}, {}});
        }
        const auto value = [&](std::size_t i) { return table.number(row, drive[i]); };
        flights.back().script.push_back({sim::ProperTime(table.number(row, duration)),
                                         {value(0), value(1), value(2)},
                                         {value(3), value(4), value(5)}});
        auto& values = flights.back().ends.emplace_back();
        std::ranges::transform(end, values.begin(), [&](std::size_t column) { return table.number(row, column); });
    }
    return flights;
}

TruthTable flights_truth_table() {
    TruthTable table;
    table.name = "flights";
    for (const char* input : {"flight", "segment", "duration", "ax", "ay", "az", "wx", "wy", "wz"}) {
        table.columns.push_back({input, ""});
    }
    for (const std::string& output : flight_columns()) {
        const bool tetrad = output.find('_') != std::string::npos;
        table.columns.push_back({output, output == "tau" ? "tau" : tetrad ? output.substr(0, 2) : "event"});
    }
    table.tolerance = 1e-10;
    // A rounding of the fast components, gamma * 1e-16, is all that fixes a transverse vector of length one.
    table.rounding = [](const std::vector<double>& expected) {
        constexpr std::size_t gamma = 5; // e0_t
        return 1e-15 * expected[gamma];
    };
    table.compute = [](const content::CsvTable& rows) { return fly(rows, default_rate); };
    table.remarks = order_of_convergence;
    return table;
}

} // namespace engine

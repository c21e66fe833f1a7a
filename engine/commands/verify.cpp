#include "engine/commands/commands.h"

#include "engine/csv_output.h"
#include "engine/failure.h"
#include "engine/verify/truth_table.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <optional>

namespace engine {
namespace {

struct Options {
    std::string table;
    std::string csv;
    std::optional<double> tolerance;
};

std::vector<std::string> names_of(const TruthTable& kind) {
    std::vector<std::string> names;
    std::ranges::transform(kind.columns, std::back_inserter(names), &TruthColumn::name);
    return names;
}

TruthTable recognise(const content::CsvTable& table) {
    std::vector<std::string> known;
    for (TruthTable& kind : known_truth_tables()) {
        if (names_of(kind) == table.header) {
            return std::move(kind);
        }
        known.push_back(kind.name);
    }
    throw sim::BadInput(table.source, "header", fmt::format("{}", fmt::join(table.header, ",")),
                        fmt::format("not a known truth table; known are {}", fmt::join(known, ", ")));
}

/// The table again, inputs as they stood and outputs as computed.
CsvOutput with_computed(const TruthTable& kind, const content::CsvTable& table, const ComputedRows& computed) {
    CsvOutput output{table.header, table.rows};
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::size_t next = 0;
        for (std::size_t column = 0; column < kind.columns.size(); ++column) {
            if (!kind.columns[column].group.empty()) {
                output.rows[row][column] = exact_text(computed[row][next++]);
            }
        }
    }
    return output;
}

void verify(const Options& options) {
    if (options.tolerance && !(std::isfinite(*options.tolerance) && *options.tolerance >= 0.0)) {
        throw sim::BadInput("--tolerance", "", fmt::format("{}", *options.tolerance),
                            "must be finite and not negative");
    }
    const content::CsvTable table = content::read_csv(options.table);
    const TruthTable kind = recognise(table);
    if (table.rows.empty()) {
        throw sim::BadInput(table.source, "", "", "no rows to verify");
    }
    const ComputedRows computed = kind.compute(table);
    const std::vector<RowError> errors = compare(kind, table, computed);
    if (!options.csv.empty()) {
        write_csv(options.csv, with_computed(kind, table, computed));
    }

    // A tolerance that somebody asks for holds for every row; the table's own gives way to what doubles can hold.
    const auto allowed = [&](const RowError& row) {
        return options.tolerance ? *options.tolerance : std::max(kind.tolerance, row.rounding);
    };
    const auto describe = [&](const RowError& row) {
        const auto index = static_cast<std::size_t>(&row - errors.data());
        return fmt::format("{:.3e} (allowed {:.1e}) in line {}, {}", row.relative_error, allowed(row),
                           table.line_numbers[index], row.group);
    };
    const RowError& largest = *std::ranges::max_element(errors, {}, &RowError::relative_error);
    const RowError& worst =
        *std::ranges::max_element(errors, {}, [&](const RowError& row) { return row.relative_error - allowed(row); });
    fmt::print("{}: {} truth table, {} rows\n", options.table, kind.name, table.rows.size());
    fmt::print("largest relative error {}\n", describe(largest));
    for (const std::string& line : kind.remarks(table)) {
        fmt::print("{}\n", line);
    }
    if (worst.relative_error > allowed(worst)) {
        throw Failure(fmt::format("{}: relative error {}", options.table, describe(worst)));
    }
}

} // namespace

void add_verify_command(CLI::App& application) {
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        application.add_subcommand("verify", "compute every row of a truth table and compare; exit 1 when one is off");
    command->group("Proof");
    command->add_option("table", options->table, "CSV, recognised by its header")->required();
    command->add_option("--csv", options->csv, "write the table with the outputs as computed");
    command->add_option("--tolerance", options->tolerance, "largest relative error allowed in any row");
    command->callback([options] { verify(*options); });
}

} // namespace engine

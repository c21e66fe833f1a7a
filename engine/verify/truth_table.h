#pragma once

#include "content/csv.h"

#include <functional>
#include <string>
#include <vector>

/// Truth tables: numbers computed elsewhere that the production code has to meet.
namespace engine {

/// A column of a truth table.
struct TruthColumn {
    std::string name;
    /// Outputs of one group are the components of one quantity: their errors are relative to its largest component.
    /// "" for an input.
    std::string group;
};

/// Outputs of each row, in the order of the table's output columns; no number (NaN) where the table's cell is empty.
using ComputedRows = std::vector<std::vector<double>>;

/// One kind of truth table, recognised by its columns.
struct TruthTable {
    std::string name;
    std::vector<TruthColumn> columns;
    double tolerance; ///< largest relative error allowed
    /// What double precision can hold in a row, given its expected outputs, where that may exceed the tolerance.
    std::function<double(const std::vector<double>& expected)> rounding = [](const auto&) { return 0.0; };
    std::function<ComputedRows(const content::CsvTable&)> compute;
    /// Further lines to print about the comparison.
    std::function<std::vector<std::string>(const content::CsvTable&)> remarks = [](const auto&) {
        return std::vector<std::string>{};
    };
};

/// The worst place of one row.
struct RowError {
    double relative_error = 0.0; ///< absolute where the expected quantity is zero
    double rounding = 0.0;
    std::string group;
};

/// Compares row by row.
std::vector<RowError> compare(const TruthTable& kind, const content::CsvTable& table, const ComputedRows& computed);

/// All kinds of truth table that the program can verify.
std::vector<TruthTable> known_truth_tables();

TruthTable flights_truth_table();
TruthTable aberration_truth_table();
TruthTable retarded_truth_table();
TruthTable sphere_outline_truth_table();
TruthTable black_body_truth_table();
TruthTable doppler_white_truth_table();
TruthTable schwarzschild_deflection_truth_table();
TruthTable schwarzschild_static_observer_truth_table();
TruthTable kerr_equatorial_deflection_truth_table();
TruthTable kerr_critical_curve_truth_table();
TruthTable warp_bridge_truth_table();
TruthTable wormhole_truth_table();

} // namespace engine

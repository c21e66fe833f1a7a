#include "engine/verify/truth_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace engine {
namespace {

struct Deviation {
    std::string group;
    double largest_error = 0.0;
    double largest_expected = 0.0;

    double relative() const { return largest_expected > 0.0 ? largest_error / largest_expected : largest_error; }
};

/// The largest error and the largest expected component of each group of one row.
std::vector<Deviation> deviations(const std::vector<TruthColumn>& outputs, const std::vector<double>& expected,
                                  const std::vector<double>& computed) {
    std::vector<Deviation> groups;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        auto group = std::ranges::find(groups, outputs[i].group, &Deviation::group);
        if (group == groups.end()) {
            group = groups.insert(groups.end(), {outputs[i].group});
        }
        // An empty cell has no number, and none must be computed.
        const bool both_none = std::isnan(computed[i]) && std::isnan(expected[i]);
        const double error = both_none ? 0.0 : std::abs(computed[i] - expected[i]);
        // Else a NaN would lose every comparison and pass.
        group->largest_error =
            std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(group->largest_error, error);
        group->largest_expected = std::max(group->largest_expected, both_none ? 0.0 : std::abs(expected[i]));
    }
    return groups;
}

} // namespace

std::vector<RowError> compare(const TruthTable& kind, const content::CsvTable& table, const ComputedRows& computed) {
    std::vector<TruthColumn> outputs;
    std::ranges::copy_if(kind.columns, std::back_inserter(outputs), [](const auto& c) { return !c.group.empty(); });
    std::vector<RowError> errors;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double> expected;
        for (const TruthColumn& output : outputs) {
            const std::size_t column = table.column(output.name);
            expected.push_back(table.rows[row][column].empty() ? std::numeric_limits<double>::quiet_NaN()
                                                               : table.number(row, column));
        }
        const auto groups = deviations(outputs, expected, computed[row]);
        const auto worst = std::ranges::max_element(groups, {}, &Deviation::relative);
        errors.push_back({worst->relative(), kind.rounding(expected), worst->group});
    }
    return errors;
}

std::vector<TruthTable> known_truth_tables() {
    return {flights_truth_table(),
            aberration_truth_table(),
            retarded_truth_table(),
            sphere_outline_truth_table(),
            black_body_truth_table(),
            doppler_white_truth_table(),
            schwarzschild_deflection_truth_table(),
            schwarzschild_static_observer_truth_table(),
            kerr_equatorial_deflection_truth_table(),
            kerr_critical_curve_truth_table(),
            warp_bridge_truth_table(),
            wormhole_truth_table()};
}

} // namespace engine

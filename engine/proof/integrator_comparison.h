#pragma once

#include "content/csv.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

/// Speed against error of the ship's integrator and of others that could stand in its place (sim/integrators.h).
namespace engine {

inline constexpr std::array comparison_rates{15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0};

/// The largest errors at the ends of a set of flights' segments.
struct MotionErrors {
    double event = 0.0;       ///< relative to the largest component of the true event
    double gamma = 0.0;       ///< relative
    double orientation = 0.0; ///< of the axes once the boost is taken out: entries of the rotation, about radians
};

/// One integrator at one rate.
struct IntegratorRow {
    std::string_view integrator;
    double rate;               ///< steps per clock unit of ship time
    double nanoseconds_a_step; ///< of processor time, median; a step's whole cost, projection included
    MotionErrors truth_table;  ///< flights.csv; orientations up to gamma 1e4, beyond which its doubles do not fix them
    MotionErrors closed_forms; ///< out and back by rapidity 10 along a skew axis; ten turns of a circle at 0.8 c
    std::optional<double> determinant_drift; ///< largest |det Lambda - 1| at the closed forms' ends below gamma 2
    double norm_drift;                       ///< largest |u.u + 1| there
};

/// The integrator that flies (sim::step), as it is called in the rows.
extern const std::string_view flying_integrator;
/// The exact exponential (sim::exact_motion), as it is called in the rows.
extern const std::string_view exact_integrator;

/// Every integrator at every rate, integrator by integrator. `flights` has the columns of flights.csv; speeds are
/// medians of `rounds` >= 1. Throws sim::BadInput for a table that is not of this kind.
std::vector<IntegratorRow> compare_integrators(const content::CsvTable& flights, int rounds);

} // namespace engine

#pragma once

#include "sim/quantities.h"

#include <string>
#include <vector>

/// Flights that are hard on an integrator, each against what is known of it in closed form.
namespace engine {

/// One quantity of a hard case.
struct HardCaseResult {
    std::string quantity; ///< what is compared with what, and its unit
    double measured;      ///< the error; NaN counts as not allowed
    double allowed;
    std::string reason; ///< of what is allowed
};

/// One hard case, as long as it takes to fly.
struct HardCase {
    std::string name;
    std::vector<HardCaseResult> (*fly)(sim::Tick tumbling_ticks); ///< only the long tumbling looks at its length
};

bool holds(const HardCaseResult& result);

/// All of them, in the order of the printed table.
const std::vector<HardCase>& hard_cases();

} // namespace engine

#pragma once

#include <string_view>

/// Whether this build computes as sim is written: every operation rounded on its own, to nearest, none reordered.
namespace sim {

/// What is wrong with the arithmetic of sim's code in this build and process, in one line; "" while all is well. Found
/// out by computing: contraction of a product and a sum into one rounding, reordering by fast-math (exact_sum.h would
/// return nothing but zeros), rounding other than to nearest, and subnormal numbers flushed to zero.
std::string_view arithmetic_trouble();

} // namespace sim

#include "sim/arithmetic.h"

#include "sim/exact_sum.h"

#include <limits>

namespace sim {
namespace {

/// A number that the compiler knows nothing about.
double unknown(double value) {
    volatile double opaque = value;
    return opaque;
}

} // namespace

std::string_view arithmetic_trouble() {
    constexpr double tiny = 0x1p-27;
    // (1 + tiny)(1 - tiny) = 1 - 2^-54, which rounds to 1; in one rounding with the sum, 2^-54 is left.
    const double product_and_sum = unknown(1.0 + tiny) * unknown(1.0 - tiny) - unknown(1.0);
    if (product_and_sum != 0.0) {
        return "floating-point contraction is on: build with -ffp-contract=off";
    }
    if (exact_sum(unknown(1.0), unknown(0x1p-60)).error != 0x1p-60) {
        return "floating-point operations are reordered: build without -ffast-math";
    }
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const bool rounds_to_nearest = unknown(1.0) + unknown(0.6 * epsilon) == 1.0 + epsilon &&
                                   unknown(1.0) + unknown(0.4 * epsilon) == 1.0 &&
                                   unknown(-1.0) - unknown(0.4 * epsilon) == -1.0;
    if (!rounds_to_nearest) {
        return "floating-point numbers do not round to the nearest";
    }
    // As a comparison of subnormals would itself be flushed, the tiny result is scaled back first.
    if (unknown(std::numeric_limits<double>::min()) * unknown(0.5) * unknown(0x1p60) == 0.0) {
        return "subnormal numbers are flushed to zero: build and link without -ffast-math";
    }
    return "";
}

} // namespace sim

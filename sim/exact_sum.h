#pragma once

/// Sums that lose nothing: a sum's rounding is itself a double (Knuth, The Art of Computer Programming 2, 4.2.2,
/// theorem B). What is added up over many ticks is kept as a double and the remainder that its roundings left.
namespace sim {

/// a + b = sum + error, exactly, for finite doubles whose sum is finite.
struct ExactSum {
    double sum;
    double error;
};
constexpr ExactSum exact_sum(double a, double b) {
    const double sum = a + b;
    const double b_counted = sum - a;
    const double a_counted = sum - b_counted;
    return {sum, (a - a_counted) + (b - b_counted)};
}

/// Adds `change` to value + remainder; `value` becomes the double nearest to the new sum, the remainder what is left.
/// Loses at most a rounding of change + remainder.
constexpr void add_exactly(double& value, double& remainder, double change) {
    const ExactSum next = exact_sum(value, change + remainder);
    value = next.sum;
    remainder = next.error;
}

} // namespace sim

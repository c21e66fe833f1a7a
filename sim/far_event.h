#pragma once

#include "sim/four_vector.h"

#include <cmath>

/// Events to twice a double's digits. A double holds 16: a thousand light-years away it steps by a kilometre. So an
/// event is an origin plus an offset from it, unevaluated. The origin goes along with whatever moves: after every
/// displacement it is the double nearest to the sum, and what the rounding left over, itself a double (Knuth, The Art
/// of Computer Programming 2, 4.2.2, theorem B), is the new offset. So the origin moves without changing the sum by a
/// bit, and a displacement loses at most a rounding of the offset: 1e-16 of 1e-16 of the distance.
namespace sim {

/// An event in the world as the sum of two: `origin`, the nearest double, and `offset`, at most half its last bit.
struct FarEvent {
    Event origin;
    Event offset;

    friend bool operator==(const FarEvent&, const FarEvent&) = default;
};

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

/// The event displaced by `by`, world, of any size.
inline FarEvent displaced(const FarEvent& from, const Event& by) {
    FarEvent to;
    const auto add = [](double origin, double offset, double step, double& new_origin, double& new_offset) {
        const ExactSum far = exact_sum(origin, step);
        const ExactSum near = exact_sum(far.sum, far.error + offset);
        new_origin = near.sum;
        new_offset = near.error;
    };
    add(from.origin.t, from.offset.t, by.t, to.origin.t, to.offset.t);
    for (int i = 0; i < 3; ++i) {
        add(from.origin.space[i], from.offset.space[i], by.space[i], to.origin.space[i], to.offset.space[i]);
    }
    return to;
}

/// From `from` to `to`: exact to a rounding where the two are near each other, however far they are from the world's
/// origin.
inline Event displacement(const FarEvent& from, const FarEvent& to) {
    return (to.origin - from.origin) + (to.offset - from.offset);
}

/// The same place and time in units `1 / factor` as long: components times `factor`, to twice a double's digits.
inline FarEvent scaled(const FarEvent& event, double factor) {
    // fma gives the product's rounding exactly; the offset's own rounding is 1e-32 of the whole.
    const auto product_error = [factor](double v) { return std::fma(v, factor, -(v * factor)); };
    const Event& o = event.origin;
    const Event error{product_error(o.t),
                      {product_error(o.space.x), product_error(o.space.y), product_error(o.space.z)}};
    return displaced({factor * o, error}, factor * event.offset);
}

} // namespace sim

#pragma once

#include "sim/exact_sum.h"
#include "sim/four_vector.h"

#include <cmath>

/// Events to twice a double's digits. A double holds 16: a thousand light-years away it steps by a kilometre. So an
/// event is an origin plus an offset from it, unevaluated. The origin goes along with whatever moves: after every
/// displacement it is the double nearest to the sum, and what that rounds off, exactly, is the new offset
/// (exact_sum.h). Moving the origin so never changes the sum, and a displacement loses no more than its own rounding.
namespace sim {

/// An event in the world as the sum of two: `origin`, the nearest double, and `offset`, at most half its last bit.
struct FarEvent {
    Event origin;
    Event offset;

    friend bool operator==(const FarEvent&, const FarEvent&) = default;
};

/// The event displaced by `by`, world, of any size.
inline FarEvent displaced(const FarEvent& from, const Event& by) {
    FarEvent to = from;
    add_exactly(to.origin.t, to.offset.t, by.t);
    for (int i = 0; i < 3; ++i) {
        add_exactly(to.origin.space[i], to.offset.space[i], by.space[i]);
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

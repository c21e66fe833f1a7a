#pragma once

#include "sim/spacetime/dual.h"
#include "sim/spacetime/lanes.h"

namespace sim {

/// The type of one element of T.
template <class T>
struct ElementOf {
    using Type = T;
};
template <class Real, int N>
struct ElementOf<Lanes<Real, N>> {
    using Type = Real;
};

template <class T>
struct SineCosine {
    T sine;
    T cosine;
};

/// Both of an angle below 1e3 in size, to about two roundings: the quarter turns are taken off in three parts (Cody &
/// Waite 1980), Taylor's series does the rest. Plain operations only, so it has lanes and gives the same bits
/// everywhere, as a library's does not.
template <class T>
SineCosine<T> sine_cosine(const T& angle) {
    // Adding and taking off 1.5 * 2^52 (or 2^23) rounds to a whole number.
    const T magic(sizeof(typename ElementOf<T>::Type) == 8 ? 6755399441055744.0 : 12582912.0);
    const auto whole = [&](const T& x) { return (x + magic) - magic; };
    const T quarters = whole(angle * T(0.63661977236758134));
    const T x =
        ((angle - quarters * T(1.5703125)) - quarters * T(4.8375129699707031e-4)) - quarters * T(7.5497899548918822e-8);
    const T x2 = x * x;
    T s(1.0), c(1.0);
    for (const double n : {15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) {
        s = T(1.0) - T(1.0 / (n * (n - 1.0))) * x2 * s;
    }
    s = x * s;
    for (const double n : {16.0, 14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0}) {
        c = T(1.0) - T(1.0 / (n * (n - 1.0))) * x2 * c;
    }
    // -2 to 2: which quarter.
    const T quarter = quarters - T(4.0) * whole(T(0.25) * quarters);
    const T odd = quarter - T(2.0) * whole(T(0.5) * quarter);
    const auto swapped = odd * odd > T(0.5);
    const T sine = select(swapped, c, s);
    const T cosine = select(swapped, s, c);
    // Quarter 0: (s, c); 1: (c, -s); 2 and -2: (-s, -c); -1: (-c, s).
    const auto half = quarter * quarter > T(2.0);
    const T sign_sine = select(half | (swapped & (quarter < T(0.0))), T(-1.0), T(1.0));
    const T sign_cosine = select(half | (swapped & (quarter > T(0.0))), T(-1.0), T(1.0));
    return {sign_sine * sine, sign_cosine * cosine};
}

} // namespace sim

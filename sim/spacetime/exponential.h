#pragma once

#include "sim/spacetime/dual.h"
#include "sim/spacetime/lanes.h"

#include <bit>
#include <cstdint>

namespace sim {

/// 2^k for whole k in [-1022, 1023].
inline double power_of_two(double k) {
    // Adding 1.5 * 2^52 leaves k in the lowest bits; shifted, they are a double's exponent.
    return std::bit_cast<double>((std::bit_cast<std::uint64_t>(k + 6755399441055744.0) + 1023u) << 52u);
}
template <int N>
Lanes<double, N> power_of_two(const Lanes<double, N>& k) {
    using Whole [[gnu::vector_size(N * sizeof(std::uint64_t))]] = std::uint64_t;
    using Real = typename Lanes<double, N>::Vector;
    const Whole bits = reinterpret_cast<Whole>(k.v + 6755399441055744.0);
    return Lanes<double, N>::of(reinterpret_cast<Real>((bits + 1023u) << 52u));
}

/// e^x for |x| <= 700, to about two roundings: the whole powers of two are taken off in two parts, Taylor's series does
/// the rest. Plain operations only, so it has lanes and gives the same bits everywhere, as a library's does not.
template <class T>
T exponential(const T& x) {
    const T magic(6755399441055744.0);
    const T k = (x * T(1.4426950408889634) + magic) - magic;
    const T r = (x - k * T(0.69314718036912382)) - k * T(1.9082149292705877e-10); // |r| <= ln 2 / 2
    T sum(1.0);
    for (const double n : {14.0, 13.0, 12.0, 11.0, 10.0, 9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0}) {
        sum = T(1.0) + T(1.0 / n) * r * sum;
    }
    return sum * power_of_two(k);
}
template <class T, int N>
Dual<T, N> exponential(const Dual<T, N>& x) {
    Dual<T, N> result(exponential(x.value));
    for (std::size_t i = 0; i < x.slope.size(); ++i) {
        result.slope[i] = result.value * x.slope[i];
    }
    return result;
}

} // namespace sim

#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

/// Several rays at once in one vector register. Every operation is IEEE's, element by element, so a lane gives the
/// same bits as a scalar, whatever its neighbours do and however wide the machine's registers are.
namespace sim {

/// Yes or no for each lane.
template <class Integer, int N>
struct LaneMask {
    using Vector [[gnu::vector_size(N * sizeof(Integer))]] = Integer;
    Vector v{}; ///< each element 0 or -1

    bool operator[](int lane) const { return v[lane] != 0; }
    void set(int lane, bool yes) { v[lane] = yes ? -1 : 0; }
    friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return {a.v & b.v}; }
    friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return {a.v | b.v}; }
    friend LaneMask operator!(const LaneMask& a) { return {~a.v}; }
};

/// `Real` is double or float; `N` a power of two. Written with the compilers' portable vector types.
template <class Real, int N>
struct Lanes {
    using Vector [[gnu::vector_size(N * sizeof(Real))]] = Real;
    using Mask = LaneMask<std::conditional_t<sizeof(Real) == 8, std::int64_t, std::int32_t>, N>;
    static constexpr int width = N;

    Vector v{};

    constexpr Lanes() = default;
    constexpr Lanes(double a) : v(Vector{} + static_cast<Real>(a)) {} // NOLINT(google-explicit-constructor): broadcast
    static constexpr Lanes of(const Vector& vector) {
        Lanes result;
        result.v = vector;
        return result;
    }

    friend Lanes operator-(const Lanes& a) { return of(-a.v); }
    friend Lanes operator+(const Lanes& a, const Lanes& b) { return of(a.v + b.v); }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return of(a.v - b.v); }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return of(a.v * b.v); }
    friend Lanes operator/(const Lanes& a, const Lanes& b) { return of(a.v / b.v); }
    // As loops: what `a.v < b.v` gives is of a type fit for the narrowest registers, and in functions compiled for
    // wider ones it falls apart into single comparisons.
    friend Mask operator<(const Lanes& a, const Lanes& b) {
        Mask result;
        for (int i = 0; i < N; ++i) {
            result.v[i] = a.v[i] < b.v[i] ? -1 : 0;
        }
        return result;
    }
    friend Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }

    /// Element by element; the library's functions have no vector form that gives the same bits everywhere.
    template <class Function>
    static Lanes each(const Lanes& a, const Function& f) {
        Lanes result;
        for (int i = 0; i < N; ++i) {
            result.v[i] = f(a.v[i]);
        }
        return result;
    }
    friend Lanes sqrt(const Lanes& a) {
        return each(a, [](Real e) { return std::sqrt(e); });
    }
    friend Lanes exp(const Lanes& a) {
        return each(a, [](Real e) { return std::exp(e); });
    }
    friend Lanes log(const Lanes& a) {
        return each(a, [](Real e) { return std::log(e); });
    }
    friend Lanes sin(const Lanes& a) {
        return each(a, [](Real e) { return std::sin(e); });
    }
    friend Lanes cos(const Lanes& a) {
        return each(a, [](Real e) { return std::cos(e); });
    }
    friend Lanes tanh(const Lanes& a) {
        return each(a, [](Real e) { return std::tanh(e); });
    }
    friend Lanes atan(const Lanes& a) {
        return each(a, [](Real e) { return std::atan(e); });
    }
    friend Lanes select(const Mask& condition, const Lanes& a, const Lanes& b) { return of(condition.v ? a.v : b.v); }
};

} // namespace sim

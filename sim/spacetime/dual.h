#pragma once

#include <array>
#include <cmath>
#include <concepts>

/// Dual numbers: a value and its derivatives along N directions, carried through every operation by the chain rule
/// (automatic differentiation, forward mode). Exact to rounding; nothing is divided by a small step.
namespace sim {

/// `T` may itself be a dual number (second derivatives) or lanes.
template <class T, int N>
struct Dual {
    T value{};
    std::array<T, N> slope{};

    constexpr Dual() = default;
    template <class U>
    requires std::convertible_to<U, T>
    constexpr Dual(const U& v) : value(v) {} // NOLINT(google-explicit-constructor): a constant is a dual number

    /// The variable that direction `i` differentiates by.
    static constexpr Dual variable(const T& v, int i) {
        Dual result(v);
        result.slope[static_cast<std::size_t>(i)] = T(1.0);
        return result;
    }

    friend constexpr Dual operator-(const Dual& a) { return chain(a, -a.value, T(-1.0)); }
    friend constexpr Dual operator+(const Dual& a, const Dual& b) {
        Dual result(a.value + b.value);
        for (std::size_t i = 0; i < N; ++i) {
            result.slope[i] = a.slope[i] + b.slope[i];
        }
        return result;
    }
    friend constexpr Dual operator-(const Dual& a, const Dual& b) {
        Dual result(a.value - b.value);
        for (std::size_t i = 0; i < N; ++i) {
            result.slope[i] = a.slope[i] - b.slope[i];
        }
        return result;
    }
    friend constexpr Dual operator*(const Dual& a, const Dual& b) {
        Dual result(a.value * b.value);
        for (std::size_t i = 0; i < N; ++i) {
            result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
        }
        return result;
    }
    friend constexpr Dual operator/(const Dual& a, const Dual& b) {
        const T reciprocal = T(1.0) / b.value;
        Dual result(a.value * reciprocal);
        for (std::size_t i = 0; i < N; ++i) {
            result.slope[i] = (a.slope[i] - result.value * b.slope[i]) * reciprocal;
        }
        return result;
    }
    friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
    friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }

    /// f(a), given f's value and derivative at a.
    static constexpr Dual chain(const Dual& a, const T& value, const T& derivative) {
        Dual result(value);
        for (std::size_t i = 0; i < N; ++i) {
            result.slope[i] = derivative * a.slope[i];
        }
        return result;
    }

    friend Dual sqrt(const Dual& a) {
        using std::sqrt;
        const T root = sqrt(a.value);
        return chain(a, root, T(0.5) / root);
    }
    friend Dual exp(const Dual& a) {
        using std::exp;
        const T e = exp(a.value);
        return chain(a, e, e);
    }
    friend Dual log(const Dual& a) {
        using std::log;
        return chain(a, log(a.value), T(1.0) / a.value);
    }
    friend Dual sin(const Dual& a) {
        using std::cos, std::sin;
        return chain(a, sin(a.value), cos(a.value));
    }
    friend Dual cos(const Dual& a) {
        using std::cos, std::sin;
        return chain(a, cos(a.value), -sin(a.value));
    }
    friend Dual tanh(const Dual& a) {
        using std::tanh;
        const T v = tanh(a.value);
        return chain(a, v, T(1.0) - v * v);
    }
    friend Dual atan(const Dual& a) {
        using std::atan;
        return chain(a, atan(a.value), T(1.0) / (T(1.0) + a.value * a.value));
    }
};

/// A number without its derivatives, all the way down.
template <class T>
constexpr const T& plain(const T& a) {
    return a;
}
template <class T, int N>
constexpr auto plain(const Dual<T, N>& a) {
    return plain(a.value);
}

/// `condition` ? a : b, element by element where T has elements.
template <class T>
constexpr T select(bool condition, const T& a, const T& b) {
    return condition ? a : b;
}

} // namespace sim

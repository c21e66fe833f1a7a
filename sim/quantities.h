#pragma once

#include <compare>
#include <cstdint>

/// Distinct types for the scalars that are easily mistaken for one another. Inside the physics c = 1: times are in
/// clock units and lengths in light clock units; a scenario says how many seconds a clock unit is.
namespace sim {

/// A double that knows what it measures; only equal kinds add and compare. `Kind` is an empty tag.
template <class Kind>
struct Quantity {
    double value = 0.0;

    constexpr Quantity() = default;
    constexpr explicit Quantity(double v) : value(v) {}
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value + b.value); }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value - b.value); }
    friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.value); }
    friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(s * a.value); }
    // clang-tidy 14 takes the defaulted comparison's hidden 0 for a null pointer.
    friend constexpr auto operator<=>(Quantity a, Quantity b) = default; // NOLINT(modernize-use-nullptr)
};

using ProperTime = Quantity<struct ProperTimeKind>;         ///< the ship's clock
using CoordinateTime = Quantity<struct CoordinateTimeKind>; ///< the world's clock
using Rapidity = Quantity<struct RapidityKind>;             ///< xi = atanh(beta)
using Radians = Quantity<struct RadiansKind>;

/// Whole fixed steps since the start of a flight.
using Tick = std::uint64_t;

} // namespace sim

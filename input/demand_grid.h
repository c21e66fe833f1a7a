#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace input {

/// A demand of a hand, rounded to a multiple of a power of two that cuts its limit (> 0, finite) into 8,192 to 16,384
/// steps, finer than a stick tells apart: flown and recorded alike, and short to record. A limit itself, and what is
/// beyond it, is the limit exactly.
inline double on_grid(double demand, double limit) {
    if (std::abs(demand) >= limit) {
        return std::copysign(limit, demand);
    }
    constexpr int bits = 14;
    int exponent = 0;
    std::frexp(limit, &exponent); // limit < 2^exponent
    const double steps = std::round(std::ldexp(demand, bits - exponent));
    return std::clamp(std::ldexp(steps, exponent - bits), -limit, limit) + 0.0; // no minus zero
}

inline glm::dvec3 on_grid(const glm::dvec3& demand, const glm::dvec3& limit) {
    return {on_grid(demand.x, limit.x), on_grid(demand.y, limit.y), on_grid(demand.z, limit.z)};
}

} // namespace input

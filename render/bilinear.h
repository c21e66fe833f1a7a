#pragma once

#include <glm/common.hpp>

#include <cmath>
#include <cstdint>

namespace render {

/// Between the four texels around a point. `x`, `y`: in texels, whole numbers at their middles; `texel(column, row)`:
/// a texel's value, wherever it is.
template <class Texel>
auto bilinear(double x, double y, const Texel& texel) {
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto column = static_cast<std::int64_t>(left);
    const auto row = static_cast<std::int64_t>(top);
    const auto upper = glm::mix(texel(column, row), texel(column + 1, row), x - left);
    const auto lower = glm::mix(texel(column, row + 1), texel(column + 1, row + 1), x - left);
    return glm::mix(upper, lower, y - top);
}

} // namespace render

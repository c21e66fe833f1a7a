#include "render/offline/traced/panorama_pyramid.h"

#include "render/panorama.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace render {
namespace {

constexpr double most_taps = 16.0;

content::Panorama halved(const content::Panorama& fine) {
    content::Panorama coarse;
    coarse.width = std::max(1, fine.width / 2);
    coarse.height = std::max(1, fine.height / 2);
    coarse.radiance.resize(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
    const auto texel = [&](int column, int row) {
        return fine
            .radiance[static_cast<std::size_t>(std::min(row, fine.height - 1)) * static_cast<std::size_t>(fine.width) +
                      static_cast<std::size_t>(std::min(column, fine.width - 1))];
    };
    for (int row = 0; row < coarse.height; ++row) {
        for (int column = 0; column < coarse.width; ++column) {
            coarse.radiance[static_cast<std::size_t>(row) * static_cast<std::size_t>(coarse.width) +
                            static_cast<std::size_t>(column)] =
                0.25f * (texel(2 * column, 2 * row) + texel(2 * column + 1, 2 * row) + texel(2 * column, 2 * row + 1) +
                         texel(2 * column + 1, 2 * row + 1));
        }
    }
    return coarse;
}

} // namespace

PanoramaPyramid::PanoramaPyramid(content::Panorama panorama) {
    levels_.push_back(std::move(panorama));
    while (levels_.back().width > 4 && levels_.back().height > 2) {
        levels_.push_back(halved(levels_.back()));
    }
}

glm::dvec3 PanoramaPyramid::at_level(const glm::dvec3& direction, double level) const {
    const double clamped = std::clamp(level, 0.0, static_cast<double>(levels_.size() - 1));
    const auto below = static_cast<std::size_t>(clamped);
    const double share = clamped - static_cast<double>(below);
    const glm::dvec3 fine = panorama_radiance(levels_[below], direction);
    return share == 0.0 ? fine : glm::mix(fine, panorama_radiance(levels_[below + 1], direction), share);
}

glm::dvec3 PanoramaPyramid::radiance(const glm::dvec3& direction, const glm::dvec3& side_u,
                                     const glm::dvec3& side_v) const {
    // The parallelogram's axes, as those of the ellipse in it: principal axes of the 2x2 form u u^T + v v^T.
    const double uu = glm::dot(side_u, side_u);
    const double vv = glm::dot(side_v, side_v);
    const double uv = glm::dot(side_u, side_v);
    const double half_difference = 0.5 * (uu - vv);
    const double root = std::hypot(half_difference, uv);
    const double longest = std::sqrt(std::max(0.0, 0.5 * (uu + vv) + root));
    const double area = std::sqrt(std::max(0.0, uu * vv - uv * uv));
    const double shortest = std::max(longest > 0.0 ? area / longest : 0.0, longest / most_taps);
    const double texel = 2.0 * std::numbers::pi / levels_.front().width;
    const double level = shortest > texel ? std::log2(shortest / texel) : 0.0;
    const int taps = shortest > 0.5 * texel
                         ? static_cast<int>(std::clamp(std::round(longest / shortest), 1.0, most_taps))
                         : static_cast<int>(std::clamp(std::round(longest / texel), 1.0, most_taps));
    if (taps == 1) {
        return at_level(direction, level);
    }
    const double angle = 0.5 * std::atan2(uv, half_difference);
    const glm::dvec3 axis = std::cos(angle) * side_u + std::sin(angle) * side_v;
    const double axis_length = glm::length(axis);
    const glm::dvec3 along = axis_length > 0.0 ? (longest / axis_length) * axis : glm::dvec3(0.0);
    glm::dvec3 sum(0.0);
    for (int i = 0; i < taps; ++i) {
        sum += at_level(glm::normalize(direction + ((i + 0.5) / taps - 0.5) * along), level);
    }
    return sum / static_cast<double>(taps);
}

} // namespace render

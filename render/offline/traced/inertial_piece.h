#pragma once

#include "render/offline/traced/ray_curve.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

namespace render {

/// A stretch of a world line with constant coordinate velocity, and the coordinates in which what moves along it is at
/// rest: the chart's relative to its centre, stretched along the velocity by gamma, for the chart sees the object
/// contracted. An event of a light ray maps with its own time, so light delay is exact where the chart's light cones
/// are those of flat space, which is where an object of finite size can move rigidly.
struct InertialPiece {
    glm::dvec3 centre_at_zero{0.0}; ///< chart, where the straight line passes at t = 0
    glm::dvec3 velocity{0.0};       ///< coordinate velocity, c = 1
    double first_time = -std::numeric_limits<double>::infinity();
    double last_time = std::numeric_limits<double>::infinity();

    /// `event` times `weight`; the place is too.
    glm::dvec3 at_rest(const glm::dvec4& event, double weight = 1.0) const {
        const glm::dvec3 offset = glm::dvec3(event.y, event.z, event.w) - weight * centre_at_zero - event.x * velocity;
        const double speed2 = glm::dot(velocity, velocity);
        if (speed2 == 0.0) {
            return offset;
        }
        const double stretch = 1.0 / std::sqrt(1.0 - speed2) - 1.0;
        return offset + stretch * glm::dot(offset, velocity) / speed2 * velocity;
    }
    RestCurve at_rest(const RayCurve& curve) const {
        RestCurve rest;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            rest[i] = glm::dvec4(at_rest(curve.points[i], curve.weights[i]), curve.weights[i]);
        }
        return rest;
    }
    bool exists_at(double time) const { return time >= first_time && time < last_time; }
    bool overlaps(const RayCurve& curve) const {
        const auto time = [&](std::size_t i) { return curve.points[i].x / curve.weights[i]; };
        const auto [low, high] = std::minmax({time(0), time(1), time(2), time(3)});
        return high >= first_time && low < last_time;
    }
};

} // namespace render

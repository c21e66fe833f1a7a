#pragma once

#include "engine/hud/canvas.h"

#include <glm/vec3.hpp>

#include <cmath>

namespace engine {

/// Where a direction in head axes is on the screen; only meaningful ahead (z < 0).
inline ImVec2 project(const Canvas& canvas, const glm::dvec3& d, double horizontal_field_of_view) {
    const double focal = 0.5 * static_cast<double>(canvas.width()) / std::tan(0.5 * horizontal_field_of_view);
    return {0.5F * canvas.width() + static_cast<float>(focal * d.x / -d.z),
            0.5F * canvas.height() - static_cast<float>(focal * d.y / -d.z)};
}

/// Between the bands of readouts.
inline bool on_screen(const Canvas& canvas, const glm::dvec3& d, ImVec2 at) {
    return d.z < -1e-3 && at.x > 12.0F && at.y > 40.0F && at.x < canvas.width() - 12.0F &&
           at.y < canvas.height() - 90.0F;
}

} // namespace engine

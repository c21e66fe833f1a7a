#pragma once

#include "render/render_frame.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace render {

/// The eye ray through a point of the picture: `x` pixels from the left edge, `y` from the top (a pixel's centre lies
/// at halves). The screen is a plane: angles off the axis enter by their tangents.
inline sim::Direction<sim::Head> head_direction_from_pixel(const EyeView& eye, double x, double y) {
    const double pixel = 2.0 * std::tan(0.5 * eye.horizontal_field_of_view) / eye.width;
    return {glm::normalize(glm::dvec3((x - 0.5 * eye.width) * pixel, (0.5 * eye.height - y) * pixel, -1.0))};
}

} // namespace render

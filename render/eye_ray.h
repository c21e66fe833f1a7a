#pragma once

#include "render/render_frame.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace render {

/// Pixels a unit tangent from the screen's axis: the screen's distance in pixels.
inline double focal_length_pixels(const EyeView& eye) {
    return 0.5 * eye.width / std::tan(0.5 * eye.horizontal_field_of_view);
}

/// The eye ray through a point of the picture: `x` pixels from the left edge, `y` from the top (a pixel's centre lies
/// at halves). The screen is a plane: angles off the axis enter by their tangents.
inline sim::Direction<sim::Head> head_direction_from_pixel(const EyeView& eye, double x, double y) {
    return {glm::normalize(glm::dvec3(x - 0.5 * eye.width, 0.5 * eye.height - y, -focal_length_pixels(eye)))};
}

} // namespace render

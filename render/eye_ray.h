#pragma once

#include "render/render_frame.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace render {

/// Pixels a unit tangent from the screen's axis: the screen's distance in pixels.
inline double focal_length_pixels(const EyeView& eye) {
    return 0.5 * eye.width / std::tan(0.5 * eye.horizontal_field_of_view);
}

/// Where the eye's axis meets the screen: pixels from the left edge and from the top.
inline glm::dvec2 axis_pixel(const EyeView& eye) {
    return {0.5 * eye.width + eye.axis_from_middle.x, 0.5 * eye.height - eye.axis_from_middle.y};
}

/// The eye ray through a point of the picture: `x` pixels from the left edge, `y` from the top (a pixel's centre lies
/// at halves). The screen is a plane: angles off the axis enter by their tangents.
inline sim::Direction<sim::Head> head_direction_from_pixel(const EyeView& eye, double x, double y) {
    const glm::dvec2 axis = axis_pixel(eye);
    return {glm::normalize(glm::dvec3(x - axis.x, axis.y - y, -focal_length_pixels(eye)))};
}

} // namespace render

#pragma once

#include "content/traced/traced_scenario.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>

namespace render {

/// How a camera's directions lie in its picture. Head axes: x right, y up, -z ahead.
struct CameraLens {
    content::Projection projection = content::Projection::perspective;
    double field_of_view = 1.0471975511965976; ///< radians across the width; the whole sky for equirectangular
    int width = 1280;                          ///< pixels
    int height = 720;
};

/// Unit head direction seen at a point of the picture, pixels from the left and the top (centres at halves).
/// Perspective: angles enter by their tangents. Fisheye: an angle t from the axis lies t width / field_of_view pixels
/// from the middle; nothing beyond half the field of view. Equirectangular: as content::Panorama: the zenith above,
/// -z in the middle, +x to the right of it.
std::optional<glm::dvec3> head_direction(const CameraLens& lens, const glm::dvec2& point);

/// Solid angle of a pixel around that point, steradian.
double pixel_solid_angle(const CameraLens& lens, const glm::dvec2& point);

} // namespace render

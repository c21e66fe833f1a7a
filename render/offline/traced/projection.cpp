#include "render/offline/traced/projection.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace render {
namespace {

using std::numbers::pi;

double focal_pixels(const CameraLens& lens) {
    return 0.5 * lens.width / std::tan(0.5 * lens.field_of_view);
}

glm::dvec2 from_middle(const CameraLens& lens, const glm::dvec2& point) {
    return {point.x - 0.5 * lens.width, 0.5 * lens.height - point.y};
}

} // namespace

std::optional<glm::dvec3> head_direction(const CameraLens& lens, const glm::dvec2& point) {
    const glm::dvec2 offset = from_middle(lens, point);
    switch (lens.projection) {
    case content::Projection::perspective:
        return glm::normalize(glm::dvec3(offset, -focal_pixels(lens)));
    case content::Projection::fisheye: {
        const double distance = glm::length(offset);
        const double angle = distance * lens.field_of_view / lens.width;
        if (angle > 0.5 * lens.field_of_view) {
            return std::nullopt;
        }
        const double sideways = distance > 0.0 ? std::sin(angle) / distance : 0.0;
        return glm::dvec3(sideways * offset, -std::cos(angle));
    }
    case content::Projection::equirectangular:
        break;
    }
    const double longitude = 2.0 * pi * offset.x / lens.width;
    const double colatitude = pi * point.y / lens.height;
    return glm::dvec3(std::sin(longitude) * std::sin(colatitude), std::cos(colatitude),
                      -std::cos(longitude) * std::sin(colatitude));
}

double pixel_solid_angle(const CameraLens& lens, const glm::dvec2& point) {
    const glm::dvec2 offset = from_middle(lens, point);
    switch (lens.projection) {
    case content::Projection::perspective: {
        const double focal = focal_pixels(lens);
        const double cosine = focal / std::hypot(focal, offset.x, offset.y);
        return cosine * cosine * cosine / (focal * focal);
    }
    case content::Projection::fisheye: {
        const double scale = lens.field_of_view / lens.width;
        const double angle = glm::length(offset) * scale;
        return scale * scale * (angle > 0.0 ? std::sin(angle) / angle : 1.0);
    }
    case content::Projection::equirectangular:
        break;
    }
    return 2.0 * pi / lens.width * (pi / lens.height) * std::abs(std::sin(pi * point.y / lens.height));
}

} // namespace render

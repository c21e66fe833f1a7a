#include "render/gl/boosted_view.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace render {
namespace {

/// A rotation that takes the unit vector `axis` to z.
glm::dmat3 z_from(const glm::dvec3& axis) {
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 x = glm::normalize(glm::cross(helper, axis));
    const glm::dvec3 y = glm::cross(axis, x);
    return glm::transpose(glm::dmat3(x, y, axis));
}

} // namespace

glm::dvec3 direction_times_ratio(const glm::dvec3& seen, double exp_rapidity) {
    const double aside2 = seen.x * seen.x + seen.y * seen.y;
    const double ahead = 0.25 * (aside2 + (seen.z + 1.0) * (seen.z + 1.0)) / exp_rapidity;
    const double behind = 0.25 * (aside2 + (seen.z - 1.0) * (seen.z - 1.0)) * exp_rapidity;
    return {seen.x, seen.y, ahead - behind};
}

glm::dvec3 BoostedView::seen(const glm::dvec2& pixel) const {
    const glm::dvec3 ray((2.0 * pixel.x / width - 1.0) * half_extent.x, (2.0 * pixel.y / height - 1.0) * half_extent.y,
                         -1.0);
    return axis_from_head * glm::normalize(ray);
}

glm::dvec3 BoostedView::direction_times_ratio(const glm::dvec2& pixel) const {
    return render::direction_times_ratio(seen(pixel), exp_rapidity);
}

BoostedView boosted_view(const EyeView& eye) {
    const sim::BoostAndRotation parts = sim::split(eye.world_from_head);
    BoostedView view;
    view.axis_from_world = z_from(parts.along);
    view.axis_from_head = view.axis_from_world * parts.boosted_from_head;
    view.rapidity = parts.xi.value;
    view.exp_rapidity = std::exp(parts.xi.value);
    const double half_width = std::tan(0.5 * eye.horizontal_field_of_view);
    view.half_extent = {half_width, half_width * eye.height / eye.width};
    view.width = eye.width;
    view.height = eye.height;
    return view;
}

} // namespace render

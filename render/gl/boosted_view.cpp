#include "render/gl/boosted_view.h"

#include "render/eye_ray.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

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
    const glm::dvec3 ray((2.0 * pixel.x / width - 1.0) * half_extent.x + middle.x,
                         (2.0 * pixel.y / height - 1.0) * half_extent.y + middle.y, -1.0);
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
    view.middle = -eye.axis_from_middle / focal_length_pixels(eye);
    view.width = eye.width;
    view.height = eye.height;
    return view;
}

ScreenRays screen_rays(const BoostedView& view) {
    const glm::dmat3& axes = view.axis_from_head;
    const glm::dvec2 corner = view.middle - view.half_extent;
    return {glm::vec3(axes[0] * corner.x + axes[1] * corner.y - axes[2]),
            glm::vec3(axes[0] * (2.0 * view.half_extent.x / view.width)),
            glm::vec3(axes[1] * (2.0 * view.half_extent.y / view.height)), static_cast<float>(view.exp_rapidity),
            glm::mat3(glm::transpose(view.axis_from_world))};
}

RatioRange ratio_range(const BoostedView& view, const glm::dvec2& low, const glm::dvec2& high) {
    const glm::dvec3 axis = glm::transpose(view.axis_from_head) * glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec2 size(view.width, view.height);
    const auto tangents = [&](const glm::dvec2& pixel) {
        return (2.0 * pixel / size - 1.0) * view.half_extent + view.middle;
    };
    RatioRange range{std::numeric_limits<double>::infinity(), 0.0};
    const auto visit = [&](double x, double y) {
        const glm::dvec2 pixel = ((glm::dvec2(x, y) - view.middle) / view.half_extent + 1.0) * 0.5 * size;
        const double d = glm::length(view.direction_times_ratio(glm::clamp(pixel, low, high)));
        range.least = std::min(range.least, d);
        range.most = std::max(range.most, d);
    };
    const glm::dvec2 near = tangents(low);
    const glm::dvec2 far = tangents(high);
    for (const double x : {near.x, far.x}) {
        visit(x, near.y);
        visit(x, far.y);
        // On the line x = const the angle to the axis is stationary where axis.y (1 + x^2) = y (axis.x x - axis.z).
        if (const double slope = axis.x * x - axis.z; std::abs(slope) > 1e-12) {
            visit(x, axis.y * (1.0 + x * x) / slope);
        }
    }
    for (const double y : {near.y, far.y}) {
        if (const double slope = axis.y * y - axis.z; std::abs(slope) > 1e-12) {
            visit(axis.x * (1.0 + y * y) / slope, y);
        }
    }
    if (std::abs(axis.z) > 1e-12) {
        visit(-axis.x / axis.z, -axis.y / axis.z);
    }
    return range;
}

} // namespace render

#include "render/panorama.h"

#include "render/bilinear.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

glm::dvec3 texel(const content::Panorama& panorama, std::int64_t column, std::int64_t row) {
    const std::int64_t x = ((column % panorama.width) + panorama.width) % panorama.width;
    const std::int64_t y = std::clamp<std::int64_t>(row, 0, panorama.height - 1);
    return {panorama.radiance[static_cast<std::size_t>(y * panorama.width + x)]};
}

} // namespace

glm::dvec3 panorama_radiance(const content::Panorama& panorama, const glm::dvec3& direction) {
    const double longitude = std::atan2(direction.x, -direction.z);
    const double colatitude = std::atan2(std::hypot(direction.x, direction.z), direction.y);
    const double x = (0.5 + 0.5 * std::numbers::inv_pi * longitude) * panorama.width - 0.5;
    const double y = std::numbers::inv_pi * colatitude * panorama.height - 0.5;
    return bilinear(x, y, [&panorama](std::int64_t column, std::int64_t row) { return texel(panorama, column, row); });
}

} // namespace render

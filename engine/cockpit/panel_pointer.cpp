#include "engine/cockpit/panel_pointer.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace engine {

std::optional<glm::dvec2> panel_place(const std::vector<content::generator::PanelScreen>& screens,
                                      const PointerRay& ray) {
    std::optional<glm::dvec2> place;
    double nearest = std::numeric_limits<double>::infinity();
    for (const content::generator::PanelScreen& screen : screens) {
        const glm::dvec3 normal = glm::cross(screen.right, screen.up);
        const double towards = glm::dot(ray.direction, normal);
        const double along = glm::dot(screen.centre - ray.origin, normal) / towards;
        if (!(towards < 0.0) || !(along >= 0.0) || along >= nearest) {
            continue; // from behind, or behind the hand
        }
        const glm::dvec3 from_centre = ray.origin + along * ray.direction - screen.centre;
        const double x = glm::dot(from_centre, screen.right) / glm::dot(screen.right, screen.right);
        const double y = glm::dot(from_centre, screen.up) / glm::dot(screen.up, screen.up);
        if (std::abs(x) <= 1.0 && std::abs(y) <= 1.0) {
            nearest = along;
            place = screen.low + glm::dvec2(0.5 + 0.5 * x, 0.5 - 0.5 * y) * (screen.high - screen.low);
        }
    }
    return place;
}

} // namespace engine

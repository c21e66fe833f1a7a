#pragma once

#include "content/generator/cabin.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace engine {

/// A hand, or the mouse, that points into the cabin. Cabin frame, metres.
struct PointerRay {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< any length but zero
};

/// Where a ray first meets the front of a screen, as shares of the instruments' picture from its upper left corner.
std::optional<glm::dvec2> panel_place(const std::vector<content::generator::PanelScreen>& screens,
                                      const PointerRay& ray);

} // namespace engine

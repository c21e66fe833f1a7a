#pragma once

#include "content/scene_desc.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

namespace content::generator {

/// A flat screen of the instruments in the cabin. Cabin frame, metres.
struct PanelScreen {
    glm::dvec3 centre{0.0};
    glm::dvec3 right{0.0}; ///< from the centre to the right edge
    glm::dvec3 up{0.0};    ///< from the centre to the upper edge
    glm::dvec2 low{0.0};   ///< upper left corner of what it shows, shares of the instruments' picture, y down
    glm::dvec2 high{1.0};  ///< lower right corner
};

/// The cabin that the pilot sits in. Cabin frame: x right, y up, -z ahead, metres; the pilot's eyes at the origin.
struct Cabin {
    Mesh mesh; ///< vertex colours are reflectances, linear
    std::vector<PanelScreen> screens;
};

/// Width over height of the picture that all screens of make_cabin() together show.
inline constexpr double panel_aspect = 1152.0 / 162.0;

/// A single seat under a glass canopy: nose, coaming, three screens on the panel, frame and sills of the canopy, side
/// consoles, seat and bulkhead. Its glass is not modelled.
Cabin make_cabin();

} // namespace content::generator

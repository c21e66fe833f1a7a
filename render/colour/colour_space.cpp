#include "render/colour/colour_space.h"

#include <glm/matrix.hpp>

namespace render {
namespace {

glm::dmat3 diagonal(const glm::dvec3& d) {
    return {d.x, 0.0, 0.0, 0.0, d.y, 0.0, 0.0, 0.0, d.z};
}

/// XYZ with Y = 1 of a chromaticity.
glm::dvec3 xyz_of(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

} // namespace

Chromaticities chromaticities(Primaries primaries) {
    return primaries == Primaries::srgb ? Chromaticities{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}}
                                        : Chromaticities{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}};
}

glm::dmat3 rgb_from_xyz(Primaries primaries) {
    const Chromaticities at = chromaticities(primaries);
    const glm::dmat3 columns(xyz_of(at.red.x, at.red.y), xyz_of(at.green.x, at.green.y), xyz_of(at.blue.x, at.blue.y));
    const glm::dvec3 luminances = glm::inverse(columns) * d65_xyz;
    return glm::inverse(columns * diagonal(luminances));
}

glm::dmat3 srgb_from_xyz() {
    return rgb_from_xyz(Primaries::srgb);
}

glm::dmat3 rgb_from_srgb(Primaries primaries) {
    return primaries == Primaries::srgb ? glm::dmat3(1.0) : rgb_from_xyz(primaries) * glm::inverse(srgb_from_xyz());
}

glm::dmat3 bradford_adaptation(const glm::dvec3& from_white, const glm::dvec3& to_white) {
    const glm::dmat3 cones_from_xyz(0.8951, -0.7502, 0.0389, 0.2664, 1.7135, -0.0685, -0.1614, 0.0367, 1.0296);
    const glm::dvec3 gain = (cones_from_xyz * to_white) / (cones_from_xyz * from_white);
    return glm::inverse(cones_from_xyz) * diagonal(gain) * cones_from_xyz;
}

} // namespace render

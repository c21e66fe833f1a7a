#include "render/offline/traced/traced_colour.h"

#include <cmath>

namespace render {

glm::dvec3 TracedColour::seen(const glm::dvec3& at_rest, double wavelength_ratio) const {
    return colour_.matrix(Mode::full, std::log(wavelength_ratio)) * at_rest;
}

glm::dvec3 TracedColour::black_body(double temperature_kelvin, double wavelength_ratio) const {
    const LogXyz light = colour_.black_bodies().at_ln(std::log(temperature_kelvin / wavelength_ratio));
    const glm::dvec3 relative(light.x_over_y, 1.0, light.z_over_y);
    return std::exp(light.ln_y - colour_.white().ln_y()) * (colour_.white().rgb_from_xyz() * relative);
}

} // namespace render

#pragma once

#include "render/colour/doppler_colour.h"

#include <glm/vec3.hpp>

namespace render {

/// Light of a curved spacetime as the eye sees it: the flight's colour code (doppler_colour.h), mode full. Radiances
/// are linear sRGB relative to the scene's white, as everywhere; D = lambda_seen / lambda_emitted, gravity included.
/// Finite for every finite D > 0.
class TracedColour {
  public:
    explicit TracedColour(double light_temperature_kelvin) : colour_(light_temperature_kelvin) {}

    /// Radiance at rest, of a spectrum as RGB under the scene's light has it, seen at D: spectrum D^-5, total D^-4.
    glm::dvec3 seen(const glm::dvec3& at_rest, double wavelength_ratio) const;
    /// A black body seen at D: one at T/D. At the scene's light temperature and D = 1 it is white of radiance 1.
    glm::dvec3 black_body(double temperature_kelvin, double wavelength_ratio) const;

    const DopplerColour& table() const { return colour_; }

  private:
    DopplerColour colour_;
};

} // namespace render

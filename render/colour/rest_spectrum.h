#pragma once

#include "content/spectrum.h"
#include "render/colour/doppler_colour.h"

#include <array>
#include <glm/vec3.hpp>

namespace render {

/// The spectra that the renderers take RGB radiances of a scene to be: sums of three smooth reflectances under one
/// black body. Everything that reflects is shifted by them (SceneWhite).
class RestSpectra {
  public:
    explicit RestSpectra(double light_temperature_kelvin);

    /// Spectral radiance at rest of light with this linear RGB, in units of a white's at 560 nm (nm; any above 0).
    double radiance(const glm::dvec3& rgb, double wavelength_nm) const;

    double light_temperature() const { return white_.light_temperature(); }

  private:
    std::array<content::TabulatedSpectrum, 3> primaries_;
    SceneWhite white_;
    double white_at_560_;
};

} // namespace render

#pragma once

#include "render/colour/doppler_colour.h"
#include "render/colour/uniform_table.h"
#include "render/render_frame.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace render {

/// Radiance at rest to radiance as seen at D, for one picture. Where spectra shift, the matrices are direct spectral
/// integrals at steps of 1e-3 in ln D over every D the eye can see, joined by cubics. That adds less than 1e-5 of the
/// white, about as much as the integrals' own steps of 1 nm do.
class SeenColour {
  public:
    /// `largest_ln_ratio`: |ln D| never exceeds it (the eye's rapidity).
    SeenColour(Mode mode, double light_temperature_kelvin, double largest_ln_ratio);

    glm::dvec3 radiance(const glm::dvec3& at_rest, double wavelength_ratio) const;

  private:
    Mode mode_;
    UniformTable<glm::dmat3> matrices_; ///< over ln D; empty where the spectra keep their shape
};

} // namespace render

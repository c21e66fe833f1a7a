#pragma once

#include "render/colour/black_body_table.h"
#include "render/render_frame.h"

#include <glm/mat3x3.hpp>

/// The colour of a scene under one black-body light, seen at D. Radiances at rest are linear sRGB with (1, 1, 1) a
/// perfect white under the scene's light (the eye is adapted to that light: linear Bradford, light to D65, the same for
/// every D, so a blue shift is seen as blue). Their spectra: three smooth reflectances times the light. Hence
/// RGB(D) = M(D) RGB(1), with M(1) = identity exactly and every grey a black body at T/D exactly.
namespace render {

/// What both the direct integrals and the tables need of the scene at rest.
class SceneWhite {
  public:
    /// `white` and `relative_xyz` (Observer::relative_xyz of the three primaries) both at D = 1.
    SceneWhite(double light_temperature_kelvin, const LogXyz& white, const glm::dmat3& relative_xyz);

    double light_temperature() const { return light_temperature_; }
    double ln_y() const { return ln_y_; } ///< of the perfect white at rest

    /// Adapted linear sRGB of XYZ whose Y is 1 for the white at rest.
    const glm::dmat3& rgb_from_xyz() const { return rgb_from_xyz_; }

    /// Weights of the three primaries that give a linear RGB back at D = 1.
    const glm::dmat3& weights_from_rgb() const { return weights_from_rgb_; }

    /// M(D) by mode from the white's XYZ at D and the relative XYZ of the three primaries at D:
    /// geometry: identity; doppler: M D^4; searchlight: D^-4; full: M. Never NaN or infinite for D in [1e-4, 1e4];
    /// where the Wien tail is below the smallest double it is 0.
    glm::dmat3 matrix(Mode mode, double ln_wavelength_ratio, const LogXyz& white_at_d,
                      const glm::dmat3& relative_xyz) const;

  private:
    double light_temperature_;
    double ln_y_;
    glm::dmat3 rgb_from_xyz_;
    glm::dmat3 weights_from_rgb_; ///< primaries' weights that give an RGB back at D = 1
};

/// M(D) by direct spectral integration at every call (about 15 microseconds): the truth for tests.
class DirectDopplerColour {
  public:
    explicit DirectDopplerColour(double light_temperature_kelvin);
    glm::dmat3 matrix(Mode mode, double ln_wavelength_ratio) const;

  private:
    Observer observer_;
    std::array<content::TabulatedSpectrum, 3> primaries_;
    SceneWhite white_;
};

/// M(D) from tables in ln D, built once a scene (under 50 ms): relative reflectances over D in [0.48, 2.2], exactly
/// constant outside because the primaries are, times the black body table.
class DopplerColour {
  public:
    explicit DopplerColour(double light_temperature_kelvin);
    glm::dmat3 matrix(Mode mode, double ln_wavelength_ratio) const;
    const BlackBodyTable& black_bodies() const { return black_bodies_; }
    const SceneWhite& white() const { return white_; }

  private:
    DopplerColour(double light_temperature_kelvin, const Observer& observer);

    BlackBodyTable black_bodies_;
    UniformTable<glm::dmat3> relative_xyz_; ///< over ln D
    SceneWhite white_;                      ///< from the tables, so that M(1) is the identity to rounding
};

} // namespace render

#pragma once

#include "content/spectrum.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

/// What the CIE 1931 2-degree observer sees of shifted light: direct spectral integrals in double precision
/// (trapezoids of 1 nm over 360 to 830 nm), the truth behind the tables.
namespace render {

/// Tristimulus values that neither underflow nor overflow: Y in natural logarithm, X and Z relative to it.
struct LogXyz {
    double ln_y = 0.0;
    double x_over_y = 1.0;
    double z_over_y = 1.0;
};

class Observer {
  public:
    Observer();

    /// XYZ of a black body's radiance, W sr^-1 m^-3 nm (no factor 683). Temperature > 0: finite for every double, for
    /// the exponent of the Wien tail at 830 nm is taken out of the integral. A black body at T seen at D is one at T/D.
    LogXyz black_body(double temperature_kelvin) const;

    /// XYZ of any spectral radiance, W sr^-1 m^-3 as a function of nm.
    template <class Spectrum>
    glm::dvec3 xyz(const Spectrum& spectrum) const {
        glm::dvec3 sum(0.0);
        for (const Sample& sample : samples_) {
            sum += spectrum(sample.nm) * sample.xyz_bar;
        }
        return sum;
    }

    /// Surfaces of reflectances F_i under a black body of the light's temperature, seen at D: their X, Y and Z, each
    /// relative to that of a perfect white under the same light at the same D. Column i belongs to F_i; an average of
    /// F_i(lambda/D) with positive weights, so within F_i's range. D^-5 B(lambda/D, T) = B(lambda, T/D) is used.
    glm::dmat3 relative_xyz(const std::array<content::TabulatedSpectrum, 3>& reflectances, double wavelength_ratio,
                            double light_temperature_kelvin) const;

  private:
    struct Sample {
        double nm;
        double inverse_fifth_power; ///< of the wavelength in units of 830 nm
        glm::dvec3 xyz_bar;
    };
    /// Planck's law times exp(c2 / (830 nm T)), without its constant factor.
    static double scaled_black_body(const Sample& sample, double temperature_kelvin);

    std::vector<Sample> samples_;
};

} // namespace render

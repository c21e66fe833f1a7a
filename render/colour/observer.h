#pragma once

#include "content/spectrum.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
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
    static constexpr double first_nm = 360.0; ///< nothing is seen below,
    static constexpr double last_nm = 830.0;  ///< nor above

    Observer();

    /// The matching functions, linear between their rows, 0 beyond.
    glm::dvec3 matching(double nm) const;

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

    /// Calls sum(nm, weighted matching functions x, y, z) at each wavelength of the integrals.
    template <class Sum>
    void xyz_each(const Sum& sum) const {
        for (const Sample& sample : samples_) {
            sum(sample.nm, sample.xyz_bar);
        }
    }

    /// The same for what bends at these received wavelengths (nm, rising): anew between all of them, by two points of
    /// Gauss. For lines, which sums over 1 nm miss.
    template <class Sum>
    void xyz_each(std::span<const double> bends, const Sum& sum) const {
        const double half_gap = 0.5 / std::sqrt(3.0);
        auto bend = std::upper_bound(bends.begin(), bends.end(), first_nm);
        for (double from = first_nm; from < last_nm;) {
            const double next_nm = std::floor(from) + 1.0;
            const double to = bend != bends.end() && *bend < next_nm ? *bend++ : next_nm;
            for (const double side : {-half_gap, half_gap}) {
                const double nm = 0.5 * (from + to) + side * (to - from);
                sum(nm, 0.5 * (to - from) * matching(nm));
            }
            from = to;
        }
    }

    /// Surfaces of reflectances F_i under a black body of the light's temperature, seen at D: their X, Y and Z, each
    /// relative to that of a perfect white under the same light at the same D. Column i belongs to F_i; an average of
    /// F_i(lambda/D) with positive weights, so within F_i's range. D^-5 B(lambda/D, T) = B(lambda, T/D) is used.
    glm::dmat3 relative_xyz(const std::array<content::TabulatedSpectrum, 3>& reflectances, double wavelength_ratio,
                            double light_temperature_kelvin) const;

    /// The same for up to three reflectances `reflectance(i, nm)` under any light. Where a light has no X, Y or Z at
    /// all, the reflectance at the red end stands for the average.
    template <class Reflectance>
    glm::dmat3 relative_xyz(std::size_t count, const Reflectance& reflectance, double wavelength_ratio,
                            const content::Spectrum& light) const {
        glm::dvec3 white(0.0);
        glm::dmat3 coloured(0.0);
        const std::optional<double> kelvin = light.black_body_kelvin();
        for (const Sample& sample : samples_) {
            const double nm = sample.nm / wavelength_ratio;
            const glm::dvec3 weight =
                (kelvin ? scaled_black_body(sample, *kelvin / wavelength_ratio) : light.at(nm)) * sample.xyz_bar;
            white += weight;
            for (std::size_t i = 0; i < count; ++i) {
                coloured[static_cast<int>(i)] += reflectance(i, nm) * weight;
            }
        }
        // Far in the red Z underflows, its weights huddling at one end of the observer, where reflectance is constant.
        for (std::size_t i = 0; i < count; ++i) {
            for (int j = 0; j < 3; ++j) {
                double& average = coloured[static_cast<int>(i)][j];
                average = white[j] > 0.0 ? average / white[j] : reflectance(i, samples_.back().nm / wavelength_ratio);
            }
        }
        return coloured;
    }

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

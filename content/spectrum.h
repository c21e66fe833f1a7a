#pragma once

#include <optional>
#include <variant>
#include <vector>

namespace content {

/// A spectrum on an even wavelength grid, linear between its samples.
struct TabulatedSpectrum {
    enum class Beyond { zero, held }; ///< what lies outside the grid: nothing, or the value at its end

    double first_nm = 0.0;
    double step_nm = 1.0; ///< > 0
    std::vector<double> values;
    Beyond beyond = Beyond::zero;

    double at(double wavelength_nm) const;
};

/// Second radiation constant h c / k, nm K (CODATA 2018, exact).
inline constexpr double second_radiation_constant_nm_kelvin = 1.438776877e7;

/// First radiation constant for radiance 2 h c^2, W m^2 sr^-1 (CODATA 2018, exact).
inline constexpr double first_radiation_constant = 1.191042972e-16;

/// Planck's spectral radiance of a black body, W sr^-1 m^-2 per metre of wavelength. Temperature > 0; underflows to 0
/// far in the Wien tail.
double black_body_radiance(double wavelength_nm, double temperature_kelvin);

/// A measured spectrum: values at rising, uneven wavelengths, linear between them.
struct SampledSpectrum {
    std::vector<double> nanometres; ///< rising, at least one
    std::vector<double> values;     ///< as many
    TabulatedSpectrum::Beyond beyond = TabulatedSpectrum::Beyond::zero;

    double at(double wavelength_nm) const;
};

/// Planck's law.
struct BlackBody {
    double kelvin = 5762.0; ///< > 0

    double at(double wavelength_nm) const { return black_body_radiance(wavelength_nm, kelvin); }
};

/// Any spectrum: a sum of products of tables and black bodies. A reflectance times a light is what a surface sends.
class Spectrum {
  public:
    using Factor = std::variant<TabulatedSpectrum, SampledSpectrum, BlackBody>;

    Spectrum() = default; ///< darkness
    explicit Spectrum(Factor factor, double scale = 1.0) : parts_{{scale, {std::move(factor)}}} {}

    double at(double wavelength_nm) const;

    /// The temperature if this is one black body and nothing else: seen at D it is one at T/D, whatever D.
    std::optional<double> black_body_kelvin() const;

    /// Wavelengths outside of which nothing is; for a part without an end 0 and infinity.
    double shortest_nm() const;
    double longest_nm() const;

    /// Wavelengths at which the slope may change, of all tables that this is made of, rising; none for black bodies.
    std::vector<double> bends() const;

    Spectrum& operator+=(const Spectrum& other);
    friend Spectrum operator+(Spectrum a, const Spectrum& b) { return a += b; }
    friend Spectrum operator*(double scale, const Spectrum& spectrum);
    friend Spectrum operator*(const Spectrum& a, const Spectrum& b);

  private:
    struct Part {
        double scale = 1.0;
        std::vector<Factor> factors;
    };
    std::vector<Part> parts_;
};

} // namespace content

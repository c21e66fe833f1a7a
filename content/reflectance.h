#pragma once

#include "content/spectrum.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// From an RGB reflectance to a spectrum: sums of smooth terms, linear in coefficients that RGB gives.
namespace content {

/// How a scene's RGB reflectances are continued beyond what the eye sees.
enum class ReflectanceModel : std::uint8_t {
    five_terms,          ///< three primaries, one term of greens, one of reds, from statistics of real surfaces
    three_primaries,     ///< flat outside the visible: plain and predictable, for verification
    dominant_wavelength, ///< Weiskopf, Kobras, Ruder 2000, 5.3: white, and a narrow line at the hue's wavelength
};

/// Names of the models, in the enumeration's order.
inline constexpr std::array<const char*, 3> reflectance_model_names{"five-terms", "three-primaries",
                                                                    "dominant-wavelength"};

/// Reflectance or emission where no eye sees at rest.
struct InvisibleBands {
    std::optional<float> ultraviolet; ///< below 350 nm, fading out until 390
    std::optional<float> infrared;    ///< above 770 nm, fading in from 730
};

/// One way of making spectra. `own`: a spectrum that the material brings, scaled by the colour's luminance.
enum class ReflectanceRule : std::uint8_t { five_terms, three_primaries, dominant_wavelength, vegetation, own };

inline constexpr std::size_t most_terms = 5;
using Coefficients = std::array<double, most_terms>;

/// Linear RGB as its least component, chroma (greatest less least) and hue: red 0, yellow 1, green 2, cyan 3, blue 4,
/// magenta 5, linear between them; < 6. Without chroma the hue is 0.
struct Hue {
    double least = 0.0;
    double chroma = 0.0;
    double sextants = 0.0;
};
Hue hue_of(const glm::dvec3& rgb);

/// Coefficients of a rule's terms for `light` (linear RGB, >= 0, with its luminance) falling on `reflectance` (linear
/// RGB, clamped to [0, 1]): the first three terms of those rules that have primaries take the coloured product, the
/// others the reflectance's features times the light's luminance. Dominant wavelengths: of the coloured product, how
/// much is white and how much of its hue. Rules of one term take the luminance alone.
Coefficients coefficients(ReflectanceRule rule, const glm::dvec3& reflectance, const glm::dvec3& light);

/// A term: its table, and which invisible bands are cut out of it to be given otherwise.
struct ReflectanceTerm {
    Spectrum spectrum;
    bool without_ultraviolet = false;
    bool without_infrared = false;

    double at(double wavelength_nm) const;
};

/// Share of the ultraviolet and of the infrared band at a wavelength, [0, 1].
double ultraviolet_share(double wavelength_nm);
double infrared_share(double wavelength_nm);

/// The fitted terms of five_terms, three_primaries and vegetation.
std::vector<Spectrum> smooth_terms(ReflectanceRule rule);

/// Rec. 709 luminance of linear RGB.
double luminance_of(const glm::dvec3& rgb);

} // namespace content

#include "content/reflectance.h"

#include "content/spectrum_data.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace content {
namespace {

double smooth_step(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// What distinguishes a surface in the infrared: how far below its square root the luminance lies (mid tones), how
/// green and how red it is; and the mid tones of leaves, whose term reaches 2: what keeps the reflectance within 1.
struct Features {
    double middle = 0.0;
    double leaf = 0.0;
    double green = 0.0;
    double red = 0.0;
};

Features features_of(const glm::dvec3& rgb) {
    const double y = luminance_of(rgb);
    const double most = std::max({rgb.r, rgb.g, rgb.b});
    if (most <= 0.0) {
        return {};
    }
    const double middle = std::sqrt(y) - y;
    return {middle, std::min(middle, 0.5 * (1.0 - most)), smooth_step((rgb.g - std::max(rgb.r, rgb.b)) / most / 0.4),
            std::clamp((rgb.r - rgb.b) / most, 0.0, 1.0)};
}

template <std::size_t count>
std::vector<Spectrum> spectra_of(const std::array<TabulatedSpectrum, count>& tables) {
    std::vector<Spectrum> spectra;
    spectra.reserve(count);
    for (const TabulatedSpectrum& table : tables) {
        spectra.emplace_back(Spectrum::Factor(table));
    }
    return spectra;
}

} // namespace

double luminance_of(const glm::dvec3& rgb) {
    return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double ultraviolet_share(double wavelength_nm) {
    return std::clamp((390.0 - wavelength_nm) / 40.0, 0.0, 1.0);
}

double infrared_share(double wavelength_nm) {
    return std::clamp((wavelength_nm - 730.0) / 40.0, 0.0, 1.0);
}

double ReflectanceTerm::at(double wavelength_nm) const {
    double share = 1.0;
    if (without_ultraviolet) {
        share -= ultraviolet_share(wavelength_nm);
    }
    if (without_infrared) {
        share -= infrared_share(wavelength_nm);
    }
    return share > 0.0 ? share * spectrum.at(wavelength_nm) : 0.0;
}

Hue hue_of(const glm::dvec3& rgb) {
    const double least = std::min({rgb.r, rgb.g, rgb.b});
    const double most = std::max({rgb.r, rgb.g, rgb.b});
    const double chroma = most - least;
    if (chroma <= 0.0) {
        return {least, 0.0, 0.0};
    }
    double sextants = 4.0 + (rgb.r - rgb.g) / chroma;
    if (most == rgb.r) {
        sextants = (rgb.g - rgb.b) / chroma;
    } else if (most == rgb.g) {
        sextants = 2.0 + (rgb.b - rgb.r) / chroma;
    }
    return {least, chroma, sextants < 0.0 ? sextants + 6.0 : sextants};
}

Coefficients coefficients(ReflectanceRule rule, const glm::dvec3& reflectance, const glm::dvec3& light) {
    const glm::dvec3 rgb = glm::clamp(reflectance, 0.0, 1.0);
    const glm::dvec3 lit = rgb * light;
    const Features features = features_of(rgb);
    const double middle = features.middle * luminance_of(light);
    switch (rule) {
    case ReflectanceRule::five_terms:
        return {lit.r, lit.g, lit.b, middle * features.green, middle * features.red};
    case ReflectanceRule::three_primaries:
        return {lit.r, lit.g, lit.b};
    case ReflectanceRule::dominant_wavelength: {
        const Hue hue = hue_of(lit);
        return {hue.least, hue.chroma};
    }
    case ReflectanceRule::vegetation:
        return {lit.r, lit.g, lit.b, features.leaf * luminance_of(light)};
    case ReflectanceRule::own:
        break;
    }
    return {luminance_of(rgb) * luminance_of(light)};
}

std::vector<Spectrum> smooth_terms(ReflectanceRule rule) {
    switch (rule) {
    case ReflectanceRule::five_terms:
        return spectra_of(reflectance_five_terms());
    case ReflectanceRule::vegetation:
        return spectra_of(reflectance_vegetation_terms());
    case ReflectanceRule::three_primaries:
    case ReflectanceRule::dominant_wavelength:
    case ReflectanceRule::own:
        break;
    }
    return spectra_of(reflectance_primaries());
}

} // namespace content

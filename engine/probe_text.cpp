#include "engine/probe_text.h"

#include "engine/hud/readouts.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace engine {
namespace {

std::string source_line(const render::ProbedLight& light) {
    switch (light.source) {
    case render::ProbedLight::Source::surface:
        return fmt::format("{}{}, {:.4g} m away", light.object.empty() ? "surface" : light.object,
                           light.material.empty() ? "" : " (" + light.material + ")", light.distance);
    case render::ProbedLight::Source::star:
        return fmt::format("star of {:.0f} K, {:.4g} light-years away", light.star_temperature, light.distance);
    case render::ProbedLight::Source::sky:
        break;
    }
    return "sky";
}

} // namespace

std::string radiance_unit(const render::ProbedLight& light) {
    return fmt::format("spectral radiance, 1: {} at 560 nm, at rest", light.source == render::ProbedLight::Source::star
                                                                          ? "the star itself"
                                                                          : "white in the scene's light");
}

glm::vec3 pure_colour(double nm) {
    const auto hump = [nm](double centre, double width) { return std::exp(-std::pow((nm - centre) / width, 2.0)); };
    const double red = hump(620.0, 55.0) + 0.35 * hump(420.0, 22.0);
    return {std::min(red, 1.0), hump(540.0, 45.0), hump(455.0, 35.0)};
}

RadianceAxis::RadianceAxis(double largest)
    : top_exponent(largest > 0.0 ? static_cast<int>(std::ceil(std::log10(largest))) : 0) {}

double RadianceAxis::height(double value) const {
    return value > 0.0 ? std::clamp(1.0 + (std::log10(value) - top_exponent) / decades, 0.0, 1.0) : 0.0;
}

std::string RadianceAxis::label(int below) const {
    const int exponent = top_exponent - below;
    return std::abs(exponent) <= 2 ? fmt::format("{:g}", std::pow(10.0, exponent)) : fmt::format("1e{}", exponent);
}

double peak_nm(const std::function<double(double)>& spectrum) {
    double best = 0.0;
    double most = 0.0;
    for (double nm = 100.0; nm <= 10000.0; nm *= 1.001) {
        if (const double value = spectrum(nm); value > most) {
            most = value;
            best = nm;
        }
    }
    return best;
}

std::vector<std::string> probe_lines(const render::ProbedLight& light) {
    std::vector<std::string> lines{source_line(light)};
    constexpr double rounding = 1e-12; // of the eye's Lorentz transformation
    const double shift = light.wavelength_ratio - 1.0;
    lines.push_back(fmt::format("D {}: {}", wavelength_ratio_text(light.wavelength_ratio),
                                std::abs(shift) < rounding ? "no shift"
                                : shift < 0.0              ? "blueshift"
                                                           : "redshift"));
    if (light.source != render::ProbedLight::Source::star) {
        lines.push_back(
            fmt::format("RGB at rest {:.4g} {:.4g} {:.4g}", light.at_rest.r, light.at_rest.g, light.at_rest.b));
        lines.push_back(fmt::format("RGB as seen {:.4g} {:.4g} {:.4g}", light.seen.r, light.seen.g, light.seen.b));
    }
    const auto peak = [](const std::function<double(double)>& spectrum) {
        const double nm = peak_nm(spectrum);
        return nm > 0.0 ? fmt::format("{:.0f} nm", nm) : std::string("no wavelength");
    };
    lines.push_back(fmt::format("strongest at {} emitted, {} received", peak(light.emitted),
                                peak([&light](double nm) { return light.received(nm); })));
    return lines;
}

} // namespace engine

#include "render/colour/star_photometry.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace render {
namespace {

const double ln_coldest = std::log(0.1);
const double ln_hottest = std::log(1e9);

glm::dvec3 adapted_rgb(const DopplerColour& colour, const LogXyz& xyz) {
    return colour.white().rgb_from_xyz() * glm::dvec3(xyz.x_over_y, 1.0, xyz.z_over_y);
}

} // namespace

StarSource star_source(const DopplerColour& colour, const content::Star& star) {
    const double ln_temperature = std::log(static_cast<double>(star.temperature));
    const double ln_magnitude = -0.4 * std::log(10.0) * static_cast<double>(star.visual_magnitude);
    const double distance = glm::length(star.position);
    return {std::log(light_of_magnitude_zero) + ln_magnitude + 2.0 * std::log(distance) -
                colour.black_bodies().at_ln(ln_temperature).ln_y,
            ln_temperature};
}

StarMode star_mode(Mode mode) {
    switch (mode) {
    case Mode::geometry:
        return {0.0, 2.0};
    case Mode::doppler:
        return {1.0, 6.0};
    case Mode::searchlight:
        return {0.0, -2.0};
    case Mode::full:
        break;
    }
    return {1.0, 2.0};
}

BlackBodyTexels black_body_texels(const DopplerColour& colour) {
    BlackBodyTexels table;
    table.texels.reserve(std::size_t{4} * BlackBodyTexels::samples);
    const double step = (ln_hottest - ln_coldest) / (BlackBodyTexels::samples - 1);
    for (int sample = 0; sample < BlackBodyTexels::samples; ++sample) {
        const LogXyz xyz = colour.black_bodies().at_ln(ln_coldest + sample * step);
        const glm::dvec3 rgb = adapted_rgb(colour, xyz);
        for (const double value : {rgb.r, rgb.g, rgb.b, xyz.ln_y}) {
            table.texels.push_back(static_cast<float>(value));
        }
    }
    table.coordinate_scale = static_cast<float>(1.0 / (step * BlackBodyTexels::samples));
    table.coordinate_offset = static_cast<float>((0.5 - ln_coldest / step) / BlackBodyTexels::samples);
    return table;
}

glm::dvec3 star_light(const DopplerColour& colour, const StarSource& source, Mode mode, double distance,
                      double wavelength_ratio) {
    const double ln_ratio = std::log(wavelength_ratio);
    const StarMode change = star_mode(mode);
    const LogXyz xyz = colour.black_bodies().at_ln(source.ln_temperature - change.temperature_shift * ln_ratio);
    const double y = std::exp(source.ln_strength + xyz.ln_y + change.exponent * ln_ratio) / (distance * distance);
    return y * adapted_rgb(colour, xyz);
}

} // namespace render

#include "render/offline/seen_colour.h"

#include <cmath>

namespace render {
namespace {

constexpr double step = 1e-3;

// One sample lies at D = 1, so that what is at rest keeps its colour exactly.
UniformTable<glm::dmat3> direct_matrices(Mode mode, double light_temperature, double largest_ln_ratio) {
    const DirectDopplerColour colour(light_temperature);
    const double steps = std::ceil(largest_ln_ratio / step) + 2.0;
    return {-steps * step, steps * step, 1 + 2 * static_cast<std::size_t>(steps),
            [&](double ln_ratio) { return colour.matrix(mode, ln_ratio); }};
}

} // namespace

SeenColour::SeenColour(Mode mode, double light_temperature_kelvin, double largest_ln_ratio) : mode_(mode) {
    if (mode == Mode::doppler || mode == Mode::full) {
        matrices_ = direct_matrices(mode, light_temperature_kelvin, largest_ln_ratio);
    }
}

glm::dvec3 SeenColour::radiance(const glm::dvec3& at_rest, double wavelength_ratio) const {
    switch (mode_) {
    case Mode::geometry:
        break;
    case Mode::searchlight: {
        const double squared = wavelength_ratio * wavelength_ratio;
        return at_rest / (squared * squared);
    }
    case Mode::doppler:
    case Mode::full:
        return matrices_.at(std::log(wavelength_ratio)) * at_rest;
    }
    return at_rest;
}

} // namespace render

#include "render/colour/doppler_colour.h"

#include "content/spectrum_data.h"
#include "render/colour/colour_space.h"
#include "render/colour/log_spectrum.h"

#include <cmath>
#include <glm/matrix.hpp>

namespace render {
namespace {

/// The primaries are constant below 380 nm and above 730 nm.
UniformTable<glm::dmat3> primaries_seen(const Observer& observer, double light_temperature_kelvin) {
    constexpr int stride = 4; // 0.4 %
    const LogObserver seen(observer);
    const StepRange shifts = seen.shifts(380.0, 730.0);
    const StepRange emitted = seen.emitted({shifts.first - 4 * stride, shifts.last + 4 * stride});
    std::vector<LogSpectrum> terms;
    for (const content::TabulatedSpectrum& primary : content::reflectance_primaries()) {
        terms.push_back(log_samples(emitted, [&](double nm) { return primary.at(nm); }));
    }
    const content::Spectrum light(content::BlackBody{light_temperature_kelvin});
    return shifted_averages(seen, log_samples(emitted, light), terms, shifts, stride).front();
}

glm::dmat3 scaled_rows(const glm::dvec3& scale, const glm::dmat3& m) {
    return {m[0] * scale, m[1] * scale, m[2] * scale};
}

} // namespace

SceneWhite::SceneWhite(double light_temperature_kelvin, const LogXyz& white, const glm::dmat3& relative_xyz)
    : light_temperature_(light_temperature_kelvin), ln_y_(white.ln_y) {
    const glm::dvec3 white_xyz(white.x_over_y, 1.0, white.z_over_y);
    rgb_from_xyz_ = srgb_from_xyz() * bradford_adaptation(white_xyz, d65_xyz);
    weights_from_rgb_ = glm::inverse(rgb_from_xyz_ * scaled_rows(white_xyz, relative_xyz));
}

glm::dmat3 SceneWhite::matrix(Mode mode, double ln_wavelength_ratio, const LogXyz& white_at_d,
                              const glm::dmat3& relative_xyz) const {
    switch (mode) {
    case Mode::geometry:
        return glm::dmat3(1.0);
    case Mode::searchlight:
        return glm::dmat3(std::exp(-4.0 * ln_wavelength_ratio));
    case Mode::doppler:
    case Mode::full:
        break;
    }
    const double ln_beaming_removed = mode == Mode::doppler ? 4.0 * ln_wavelength_ratio : 0.0;
    const double y = std::exp(white_at_d.ln_y - ln_y_ + ln_beaming_removed);
    const glm::dvec3 white_xyz = y * glm::dvec3(white_at_d.x_over_y, 1.0, white_at_d.z_over_y);
    return rgb_from_xyz_ * scaled_rows(white_xyz, relative_xyz) * weights_from_rgb_;
}

DirectDopplerColour::DirectDopplerColour(double light_temperature_kelvin)
    : primaries_(content::reflectance_primaries()),
      white_(light_temperature_kelvin, observer_.black_body(light_temperature_kelvin),
             observer_.relative_xyz(primaries_, 1.0, light_temperature_kelvin)) {}

glm::dmat3 DirectDopplerColour::matrix(Mode mode, double ln_wavelength_ratio) const {
    const double ratio = std::exp(ln_wavelength_ratio);
    return white_.matrix(mode, ln_wavelength_ratio, observer_.black_body(white_.light_temperature() / ratio),
                         observer_.relative_xyz(primaries_, ratio, white_.light_temperature()));
}

DopplerColour::DopplerColour(double light_temperature_kelvin) : DopplerColour(light_temperature_kelvin, Observer()) {}

DopplerColour::DopplerColour(double light_temperature_kelvin, const Observer& observer)
    : black_bodies_(observer), relative_xyz_(primaries_seen(observer, light_temperature_kelvin)),
      white_(light_temperature_kelvin, black_bodies_.at_ln(std::log(light_temperature_kelvin)), relative_xyz_.at(0.0)) {
}

glm::dmat3 DopplerColour::matrix(Mode mode, double ln_wavelength_ratio) const {
    const double ln_temperature = std::log(white_.light_temperature()) - ln_wavelength_ratio;
    return white_.matrix(mode, ln_wavelength_ratio, black_bodies_.at_ln(ln_temperature),
                         relative_xyz_.at(ln_wavelength_ratio));
}

} // namespace render

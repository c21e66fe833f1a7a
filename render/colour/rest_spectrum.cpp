#include "render/colour/rest_spectrum.h"

#include "content/spectrum_data.h"

namespace render {
namespace {

SceneWhite white_of(const std::array<content::TabulatedSpectrum, 3>& primaries, double temperature) {
    const Observer observer;
    return {temperature, observer.black_body(temperature), observer.relative_xyz(primaries, 1.0, temperature)};
}

} // namespace

RestSpectra::RestSpectra(double light_temperature_kelvin)
    : primaries_(content::reflectance_primaries()), white_(white_of(primaries_, light_temperature_kelvin)),
      white_at_560_(content::black_body_radiance(560.0, light_temperature_kelvin)) {}

double RestSpectra::radiance(const glm::dvec3& rgb, double wavelength_nm) const {
    const glm::dvec3 weights = white_.weights_from_rgb() * rgb;
    double reflectance = 0.0;
    for (int i = 0; i < 3; ++i) {
        reflectance += weights[i] * primaries_[static_cast<std::size_t>(i)].at(wavelength_nm);
    }
    return reflectance * content::black_body_radiance(wavelength_nm, white_.light_temperature()) / white_at_560_;
}

} // namespace render

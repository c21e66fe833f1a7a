#include "render/colour/observer.h"

#include "content/spectrum_data.h"

#include <cmath>

namespace render {
namespace {

constexpr int whole_first_nm = static_cast<int>(Observer::first_nm);
constexpr int whole_last_nm = static_cast<int>(Observer::last_nm);

} // namespace

Observer::Observer() {
    const auto matching = content::cie_1931_observer();
    for (int nm = whole_first_nm; nm <= whole_last_nm; ++nm) {
        const double weight = nm == whole_first_nm || nm == whole_last_nm ? 0.5 : 1.0;
        samples_.push_back({static_cast<double>(nm), std::pow(last_nm / nm, 5.0),
                            weight * glm::dvec3(matching[0].at(nm), matching[1].at(nm), matching[2].at(nm))});
    }
}

glm::dvec3 Observer::matching(double nm) const {
    if (nm < first_nm || nm > last_nm) {
        return glm::dvec3(0.0);
    }
    const auto left = std::min(static_cast<std::size_t>(nm - first_nm), samples_.size() - 2);
    // The sums' weights are halves at both ends.
    const auto row = [&](std::size_t i) {
        return (i == 0 || i + 1 == samples_.size() ? 2.0 : 1.0) * samples_[i].xyz_bar;
    };
    const double share = nm - samples_[left].nm;
    return (1.0 - share) * row(left) + share * row(left + 1);
}

double Observer::scaled_black_body(const Sample& sample, double temperature_kelvin) {
    const double x = content::second_radiation_constant_nm_kelvin / (sample.nm * temperature_kelvin);
    const double x_last = content::second_radiation_constant_nm_kelvin / (last_nm * temperature_kelvin);
    return sample.inverse_fifth_power * std::exp(x_last - x) / -std::expm1(-x);
}

LogXyz Observer::black_body(double temperature_kelvin) const {
    glm::dvec3 sum(0.0);
    for (const Sample& sample : samples_) {
        sum += scaled_black_body(sample, temperature_kelvin) * sample.xyz_bar;
    }
    constexpr double last_metres = 1e-9 * last_nm;
    const double ln_scale = std::log(content::first_radiation_constant / std::pow(last_metres, 5.0)) -
                            content::second_radiation_constant_nm_kelvin / (last_nm * temperature_kelvin);
    return {std::log(sum.y) + ln_scale, sum.x / sum.y, sum.z / sum.y};
}

glm::dmat3 Observer::relative_xyz(const std::array<content::TabulatedSpectrum, 3>& reflectances,
                                  double wavelength_ratio, double light_temperature_kelvin) const {
    return relative_xyz(
        3, [&](std::size_t i, double nm) { return reflectances[i].at(nm); }, wavelength_ratio,
        content::Spectrum(content::BlackBody{light_temperature_kelvin}));
}

} // namespace render

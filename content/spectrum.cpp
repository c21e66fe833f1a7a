#include "content/spectrum.h"

#include <algorithm>
#include <cmath>

namespace content {

double TabulatedSpectrum::at(double wavelength_nm) const {
    const double position = (wavelength_nm - first_nm) / step_nm;
    const double last = static_cast<double>(values.size() - 1);
    if (beyond == Beyond::zero && (position < 0.0 || position > last)) {
        return 0.0;
    }
    const double clamped = std::clamp(position, 0.0, last);
    const auto left = std::min(static_cast<std::size_t>(clamped), values.size() - 2);
    const double fraction = clamped - static_cast<double>(left);
    return values[left] + fraction * (values[left + 1] - values[left]);
}

double black_body_radiance(double wavelength_nm, double temperature_kelvin) {
    const double metres = 1e-9 * wavelength_nm;
    const double x = second_radiation_constant_nm_kelvin / (wavelength_nm * temperature_kelvin);
    return first_radiation_constant / (std::pow(metres, 5.0) * std::expm1(x));
}

} // namespace content

#include "render/colour/black_body_table.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double middle_nm = 560.0;
constexpr double reddest_nm = Observer::last_nm;
const double largest_place = std::log1p(content::second_radiation_constant_nm_kelvin / (middle_nm * 20.0)); // 20 K
constexpr std::size_t samples = 512;

/// Even steps of ln (1 + c2 / (560 nm T)): of ln T in the Wien tail, of 1/T where the Rayleigh-Jeans law begins.
double place(double inverse_temperature) {
    return std::log1p(content::second_radiation_constant_nm_kelvin / middle_nm * inverse_temperature);
}

/// What is steepest of ln Y: the Wien tail at the red end, and T in the Rayleigh-Jeans law.
double steepest(double ln_temperature, double inverse_temperature) {
    return ln_temperature - content::second_radiation_constant_nm_kelvin / reddest_nm * inverse_temperature;
}

} // namespace

BlackBodyTable::BlackBodyTable(const Observer& observer)
    : table_(0.0, largest_place, samples, [&](double at) {
          constexpr double hottest = 1e12; // stands for no end
          const double inverse =
              std::max(std::expm1(at) * middle_nm / content::second_radiation_constant_nm_kelvin, 1.0 / hottest);
          const LogXyz xyz = observer.black_body(1.0 / inverse);
          return glm::dvec3(xyz.ln_y - steepest(-std::log(inverse), inverse), xyz.x_over_y, xyz.z_over_y);
      }) {}

LogXyz BlackBodyTable::at_ln(double ln_temperature_kelvin) const {
    const double inverse = std::exp(-ln_temperature_kelvin);
    const glm::dvec3 value = table_.at(place(inverse));
    return {value.x + steepest(ln_temperature_kelvin, inverse), value.y, value.z};
}

} // namespace render

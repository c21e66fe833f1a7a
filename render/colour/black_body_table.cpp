#include "render/colour/black_body_table.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

const double ln_coldest = std::log(0.1);
const double ln_hottest = std::log(1e9);

/// The steepest part of ln Y, the Wien tail at the red end of the observer, taken out of what is interpolated.
double wien_exponent(double ln_temperature) {
    return content::second_radiation_constant_nm_kelvin / 830.0 * std::exp(-ln_temperature);
}

} // namespace

BlackBodyTable::BlackBodyTable(const Observer& observer)
    : table_(ln_coldest, ln_hottest, 1024, [&](double ln_temperature) {
          const LogXyz xyz = observer.black_body(std::exp(ln_temperature));
          return glm::dvec3(xyz.ln_y + wien_exponent(ln_temperature), xyz.x_over_y, xyz.z_over_y);
      }) {}

LogXyz BlackBodyTable::at_ln(double ln_temperature_kelvin) const {
    const double inside = std::clamp(ln_temperature_kelvin, ln_coldest, ln_hottest);
    const glm::dvec3 value = table_.at(inside);
    const double beyond_hottest = std::max(ln_temperature_kelvin - ln_hottest, 0.0);
    return {value.x - wien_exponent(inside) + beyond_hottest, value.y, value.z};
}

} // namespace render

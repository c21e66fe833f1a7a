#include "render/colour/false_colour_scale.h"

#include <cmath>
#include <numbers>

namespace render {

ShiftScale shift_scale(sim::Rapidity rapidity) {
    constexpr double lines_on_a_side = 8.0;
    const double largest = std::abs(rapidity.value) / std::numbers::ln2;
    double step = 1.0 / 64.0; // at rest there is nothing finer to tell
    while (step * lines_on_a_side < largest) {
        step *= 2.0;
    }
    return {std::fmax(std::ceil(largest / step), 4.0) * step, step};
}

} // namespace render

#include "sim/spacetime/custom_spacetime.h"

namespace sim {

Region CustomSpacetime::region(const Components<double>& x) const {
    // Gauss's elimination, space first: positive pivots, then a negative one (Sylvester).
    SymmetricTensor<double> g = metric(x);
    constexpr std::array order{3, 2, 1, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        const double pivot = g(order[i], order[i]);
        if (!std::isfinite(pivot) || !(i < 3 ? pivot > 0.0 : pivot < 0.0)) {
            return Region::singular;
        }
        for (std::size_t j = i + 1; j < 4; ++j) {
            for (std::size_t k = j; k < 4; ++k) {
                g(order[j], order[k]) -= g(order[i], order[j]) * g(order[i], order[k]) / pivot;
            }
        }
    }
    return Region::outside;
}

} // namespace sim

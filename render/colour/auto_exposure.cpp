#include "render/colour/auto_exposure.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double middle_grey = 0.18;
constexpr double brightest_shown = 4.0; // the filmic curve's value there is 0.94

std::size_t rank(const std::vector<float>& sorted, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
}

} // namespace

double well_exposed_factor(std::vector<float>& luminances) {
    std::sort(luminances.begin(), luminances.end());
    if (luminances.empty() || !(luminances.back() > 0.0f)) {
        return 0.0;
    }
    const auto highlight = static_cast<double>(luminances[rank(luminances, 0.99)]);
    const double bright = highlight > 0.0 ? highlight : static_cast<double>(luminances.back());
    const double floor = bright * 0x1p-9; // blacker than this is black, however black
    double sum = 0.0;
    const std::size_t first = rank(luminances, 0.15);
    const std::size_t last = rank(luminances, 0.97);
    for (std::size_t i = first; i <= last; ++i) {
        sum += std::log2(std::max(static_cast<double>(luminances[i]), floor));
    }
    const double average = std::exp2(sum / static_cast<double>(last - first + 1));
    return std::min(middle_grey / average, brightest_shown / bright);
}

double AutoExposure::adapt(std::vector<float>& luminances, double seconds, double compensation_stops) {
    const double wanted = well_exposed_factor(luminances);
    if (wanted > 0.0) {
        const double target = std::clamp(wanted, std::exp2(darkest_stops), std::exp2(brightest_stops));
        const double time_constant = target < factor_ ? 0.25 : 0.7; // seconds
        const double share = adapted_ && seconds > 0.0 ? 1.0 - std::exp(-seconds / time_constant) : 1.0;
        factor_ *= std::pow(target / factor_, share);
        adapted_ = true;
    }
    return factor_ * std::exp2(compensation_stops);
}

} // namespace render

#include "render/colour/auto_exposure.h"

#include "render/colour/false_colour_scale.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double brightest_shown = 4.0; // the filmic curve's value there is 0.94

std::size_t rank(const std::vector<float>& values, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
}

/// Puts what would stand at `rank`, were the values from `first` on sorted, there: smaller ones before it, larger ones
/// behind it.
float place(std::vector<float>& values, std::size_t first, std::size_t rank) {
    const auto begin = values.begin();
    std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(rank),
                     values.end());
    return values[rank];
}

} // namespace

double well_exposed_factor(MeteredLight metered) {
    std::vector<float>& brightest = metered.brightest;
    std::vector<float>& mean = metered.mean;
    if (mean.empty() || brightest.empty()) {
        return 0.0;
    }
    const std::size_t wide_rank = rank(brightest, 0.98);
    const auto wide = static_cast<double>(place(brightest, 0, wide_rank));
    const float highlight = place(brightest, wide_rank, rank(brightest, 0.999));
    const auto bright =
        static_cast<double>(highlight > 0.0f ? highlight : *std::max_element(brightest.begin(), brightest.end()));
    if (!(bright > 0.0)) {
        return 0.0;
    }
    const double black = bright * 0x1p-9; // darker than this is black, however dark
    const auto dark =
        std::count_if(mean.begin(), mean.end(), [black](float v) { return v < static_cast<float>(black); });
    const double black_share = static_cast<double>(dark) / static_cast<double>(mean.size());
    double sum = 0.0;
    const std::size_t first = rank(mean, 0.15);
    const std::size_t last = rank(mean, 0.97);
    place(mean, 0, first);
    place(mean, first, last);
    for (std::size_t i = first; i <= last; ++i) {
        sum += std::log2(std::max(static_cast<double>(mean[i]), black));
    }
    const double stops = std::log2(shown_middle_grey) - sum / static_cast<double>(last - first + 1);
    const auto stops_too_bright = [stops](double light) {
        return light > 0.0 ? std::max(stops - std::log2(brightest_shown / light), 0.0) : 0.0;
    };
    // A lamp may glare; a stop at most is given for what fills a fiftieth. On a black sky the bright spots are the
    // picture.
    const double given = std::min(stops_too_bright(wide), 1.0) + 5.0 * black_share;
    return std::exp2(stops - std::min(stops_too_bright(bright), given));
}

double AutoExposure::adapt_to(double wanted, double seconds, double compensation_stops) {
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

#pragma once

#include <vector>

namespace render {

/// Smooth automatic exposure from the luminances of the picture. The factor it settles at puts the log-average (the
/// middle of the sorted luminances, dark and bright ends trimmed) at a middle grey, but never the brightest per cent
/// above what the filmic curve still tells apart. Adapts like an eye: faster to the bright than to the dark.
class AutoExposure {
  public:
    static constexpr double darkest_stops = -24.0; ///< the factor stays within these powers of two
    static constexpr double brightest_stops = 12.0;

    /// Factor on radiance for the next picture. `luminances` (before any exposure, >= 0) of equal parts of the picture
    /// are reordered; without light in them the factor stays. The first time, and when `seconds` <= 0, it adapts at
    /// once. Compensation multiplies by 2^stops on top.
    double adapt(std::vector<float>& luminances, double seconds, double compensation_stops);

    /// The factor that pictures are adapted to now, compensation left out; `guess` before the first.
    double current(double guess) const { return adapted_ ? factor_ : guess; }

  private:
    bool adapted_ = false;
    double factor_ = 1.0;
};

/// The factor at which these luminances (reordered) are well exposed; 0 when there is no light.
double well_exposed_factor(std::vector<float>& luminances);

} // namespace render

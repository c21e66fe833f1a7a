#pragma once

#include <utility>
#include <vector>

namespace render {

/// How bright a picture is: luminances (before any exposure, >= 0) of equal parts of it, their means and the brightest
/// spot in each.
struct MeteredLight {
    std::vector<float> mean;
    std::vector<float> brightest;
};

/// The factor on radiance at which a picture is well exposed; 0 when there is no light in it.
double well_exposed_factor(MeteredLight metered);

/// Smooth automatic exposure. The factor it settles at puts the log-average of the means (dark and bright ends trimmed)
/// at a middle grey; what is brightest takes it back to where the filmic curve still tells it apart, by a stop at most
/// where it fills a fiftieth of the picture (a lamp may glare), by more the more of the picture is black: for stars the
/// brightest spots are what counts. Adapts like an eye: faster to the bright than to the dark.
class AutoExposure {
  public:
    /// The factor stays within these powers of two: searchlights at rapidity 6 do not blind, and a night under the
    /// stars, 20 stops below noon, is as dark as an eye still sees.
    static constexpr double darkest_stops = -24.0;
    static constexpr double brightest_stops = 20.0;

    /// Factor on radiance for the next picture. Without light in the metered picture the factor stays. The first time,
    /// and when `seconds` <= 0, it adapts at once. Compensation multiplies by 2^stops on top.
    double adapt(MeteredLight metered, double seconds, double compensation_stops) {
        return adapt_to(well_exposed_factor(std::move(metered)), seconds, compensation_stops);
    }

    /// The same for a picture whose well_exposed_factor is known.
    double adapt_to(double wanted, double seconds, double compensation_stops);

    /// The factor that pictures are adapted to now, compensation left out; `guess` before the first.
    double current(double guess) const { return adapted_ ? factor_ : guess; }

  private:
    bool adapted_ = false;
    double factor_ = 1.0;
};

} // namespace render

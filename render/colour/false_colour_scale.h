#pragma once

#include "sim/quantities.h"

namespace render {

/// How D becomes a false colour: log2 D from -range to range; iso-lines at whole multiples of `step`.
struct ShiftScale {
    double range = 1.0;
    double step = 0.25;
};

/// The scale for an eye at this rapidity: it reaches every D that can be seen, with four to eight iso-lines on each
/// side of D = 1, at powers of two of D or at their roots.
ShiftScale shift_scale(sim::Rapidity rapidity);

/// How luminance becomes a false colour: stops on the exposed middle grey.
struct BrightnessScale {
    double darkest = -10.0;
    double brightest = 6.0;
    double step = 2.0; ///< of the iso-lines
};

inline constexpr double shown_middle_grey = 0.18;

} // namespace render

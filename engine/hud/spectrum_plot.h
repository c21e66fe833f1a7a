#pragma once

#include "engine/hud/hud_model.h"

#include <string>

namespace engine {

class Canvas;

/// Where the plot lies, points: in the upper right.
struct PlotPlace {
    float left;
    float top;
    float bottom;
};
PlotPlace spectrum_plot_place(const Canvas& canvas, const HudProbe& probe);

/// The plot's vertical scale: whole powers of ten, the uppermost not below the largest value.
struct RadianceAxis {
    static constexpr int decades = 6;

    explicit RadianceAxis(double largest);

    /// How high a value lies, 0 to 1; what is below the scale, or dark, at 0.
    double height(double value) const;
    /// "1", "0.01", "1e-6": the value `below` powers of ten under the uppermost.
    std::string label(int below) const;

    int top_exponent;
};

/// Plots what the probe found over logarithmic scales: the spectrum as emitted and as received, the visible band in its
/// colours over the whole height, and along the foot the same colours where they were emitted. Marks the point it
/// points at.
void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe);

} // namespace engine

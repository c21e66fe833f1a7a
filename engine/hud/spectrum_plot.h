#pragma once

#include "engine/hud/hud_model.h"

namespace engine {

class Canvas;

/// Where the plot lies, points: in the upper right.
struct PlotPlace {
    float left;
    float top;
    float bottom;
};
PlotPlace spectrum_plot_place(const Canvas& canvas, const HudProbe& probe);

/// Plots what the probe found over logarithmic scales: the spectrum as emitted and as received, the visible band in its
/// colours over the whole height, and along the foot the same colours where they were emitted. Marks the point it
/// points at.
void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe);

} // namespace engine

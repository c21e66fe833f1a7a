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

/// Plots what the probe found: the spectrum as emitted and as received, the visible band marked, both scales
/// logarithmic; and marks the point it points at.
void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe);

} // namespace engine

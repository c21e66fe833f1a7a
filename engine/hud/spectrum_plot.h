#pragma once

#include "engine/hud/hud_model.h"

namespace engine {

class Canvas;

/// Plots what the probe found: the spectrum as emitted and as received, the visible band marked, both scales
/// logarithmic; and marks the point it points at.
void draw_spectrum_plot(Canvas& canvas, const HudProbe& probe);

} // namespace engine

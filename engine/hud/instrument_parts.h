#pragma once

#include "engine/hud/canvas.h"
#include "engine/hud/hud_model.h"

namespace engine {

/// Pieces of the instruments, wherever they are put: over the window, or on a screen in the cockpit. Places in points.

/// A label over its value; returns where the next may begin.
float readout(Canvas& canvas, ImVec2 at, const std::string& label, const std::string& value, float least_width);

/// Speed in large figures, gamma, rapidity and D ahead in a row 50 points high, from its upper left corner on.
void draw_motion_readouts(Canvas& canvas, const HudModel& model, ImVec2 at);

/// A scale on which equal lengths are equal rapidities, marked in beta: how much nearer c one comes, and how little
/// that is. `y`: of its line; 12 points above it and 20 below are drawn on.
void draw_rapidity_scale(Canvas& canvas, sim::Rapidity rapidity, float from, float to, float y);

} // namespace engine

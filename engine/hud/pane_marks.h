#pragma once

#include "engine/hud/hud_model.h"

namespace engine {

class Canvas;

/// What the instruments draw into each pane of the picture: the marks of nose and motion, the pane's name where there
/// are several, the legend of its colours and lines.
void draw_panes(Canvas& canvas, const HudModel& model);

} // namespace engine

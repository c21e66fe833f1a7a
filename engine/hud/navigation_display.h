#pragma once

#include "engine/hud/canvas.h"
#include "engine/hud/hud_model.h"

namespace engine {

/// Clocks as they are seen, the target as it is seen and where it is now, assists that are on, and the forecast.
void draw_navigation(Canvas& canvas, const HudModel& model);

} // namespace engine

#pragma once

#include "engine/hud/canvas.h"
#include "engine/hud/hud_model.h"

#include <string>
#include <vector>

namespace engine {

/// A line of what the instruments say of the voyage.
struct NavigationLine {
    std::string text;
    ImU32 colour;
};

/// Target, forecast, assists, propellant.
std::vector<NavigationLine> voyage_lines(const HudModel& model);
/// What is read on every clock now, how its light is shifted, and what it shows now in the world.
std::vector<std::string> clock_lines(const HudModel& model);

/// Clocks as they are seen, the target as it is seen and where it is now, assists that are on, and the forecast.
void draw_navigation(Canvas& canvas, const HudModel& model);

} // namespace engine

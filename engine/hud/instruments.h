#pragma once

#include "engine/hud/hud_model.h"
#include "engine/hud/imgui_layer.h"

namespace engine {

/// Draws the instruments over the whole of the current ImGui frame, below all windows.
void draw_instruments(const HudModel& model, const ImguiLayer& layer);

/// Draws the table of controls in the middle of the current ImGui frame.
void draw_help(const ImguiLayer& layer);

} // namespace engine

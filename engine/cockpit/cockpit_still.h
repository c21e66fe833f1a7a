#pragma once

#include "content/scene_desc.h"
#include "engine/hud/hud_model.h"
#include "render/render_frame.h"

namespace engine {

/// Draws the cabin over a finished still of an eye that looks straight ahead in it. `instruments`: what its screens
/// show; `exposure_stops`: the still's. Brings its own OpenGL context; throws sim::BadInput where there is none.
void draw_cockpit_over(content::Image& still, const content::SceneDesc& scene, const render::RenderFrame& frame,
                       const HudModel& instruments, double exposure_stops);

} // namespace engine

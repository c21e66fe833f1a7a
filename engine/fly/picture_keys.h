#pragma once

#include "engine/frame_builder.h"
#include "input/bindings.h"

namespace engine {

/// The share of the light that glare takes when it is switched on.
inline constexpr float usual_bloom = 0.08F;

/// What a key press changes in the picture: mode, exposure, curve, view, iso-lines, panes, glare. Other actions change
/// nothing.
void change_picture(input::Action action, PictureSettings& picture);

/// Whether a demonstration leaves an action to whoever runs it: menus, files, the window itself.
bool is_locked_in_demo(input::Action action);

} // namespace engine

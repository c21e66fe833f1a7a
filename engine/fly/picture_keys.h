#pragma once

#include "engine/frame_builder.h"
#include "input/bindings.h"

namespace engine {

/// The share of the light that glare takes when it is switched on.
inline constexpr float usual_bloom = 0.08F;

/// What a key press changes in how the picture is shown: view, iso-lines, panes, glare. Other actions change nothing.
void change_display(input::Action action, PictureSettings& picture);

} // namespace engine

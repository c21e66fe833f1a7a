#pragma once

#include "engine/frame_builder.h"

namespace engine {

/// The panel's settings of how the picture is shown: false colours, iso-lines, panes, glare.
void draw_display_settings(PictureSettings& picture);

} // namespace engine

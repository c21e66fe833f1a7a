#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"

#include <span>

namespace render {

/// Adds the stars to a picture's light: each a point where double precision puts it, its light spread over a footprint
/// of a few pixels (shared/star.glsl) and dimmed in each by `sky_shares`, the part of the pixel that shows sky.
void add_stars(const content::SceneDesc& scene, const RenderFrame& frame, std::span<const float> sky_shares,
               Picture& light);

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"

namespace render {

/// A picture's light as a display is given it: exposed, brought into the gamut, through the curve, sRGB-encoded, by the
/// mathematics of the display pass. Automatic exposure adapts to this picture at once.
content::Image shown_picture(const Picture& radiance, const Exposure& exposure);

} // namespace render

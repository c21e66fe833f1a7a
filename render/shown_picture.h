#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"

namespace render {

/// Stops on radiance that the settings come to for this picture; automatic ones adapt to it at once.
double exposure_stops(const Picture& radiance, const Exposure& exposure);

/// A picture's light as a display is given it: exposed, brought into the gamut, through the curve, sRGB-encoded, by the
/// mathematics of the display pass.
content::Image shown_picture(const Picture& radiance, const Exposure& exposure);

} // namespace render

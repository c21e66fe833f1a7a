#pragma once

#include "content/scene_desc.h"
#include "render/colour/auto_exposure.h"
#include "render/colour/colour_space.h"
#include "render/render_frame.h"

namespace render {

/// How bright a picture of radiance is, by the squares that the display pass meters.
MeteredLight metered(const Picture& radiance);

/// Stops on radiance that the settings come to for this picture; automatic ones adapt to it at once.
double exposure_stops(const Picture& radiance, const Exposure& exposure);

/// A picture's light as a display with these primaries is given it, by the mathematics of the display pass: exposed,
/// bloom, brought into the gamut, through the curve, encoded by sRGB's transfer function; or the frame's view of it in
/// false colour. `stops`: exposure_stops. The picture is that of the frame's eye.
content::Image shown_picture(const Picture& radiance, const RenderFrame& frame, double stops,
                             Primaries primaries = Primaries::srgb);

/// The light alone as 8-bit sRGB, every pixel rounded to its nearest step: for comparisons of pictures.
content::Image shown_picture(const Picture& radiance, const Exposure& exposure);

/// Linear sRGB light (3 channels) in the components of other primaries: the same colours, nothing clipped.
Picture in_primaries(Picture light, Primaries primaries);

} // namespace render

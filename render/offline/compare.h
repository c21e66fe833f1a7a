#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"

namespace render {

/// Peak signal-to-noise ratio of two 8-bit pictures of one size, dB over all three colours; infinite when they are
/// equal. Throws std::invalid_argument for different sizes.
double peak_signal_to_noise(const content::Image& a, const content::Image& b);

/// |a - b| four times enlarged, to look at.
content::Image difference_picture(const content::Image& a, const content::Image& b);

/// Edge displacement beyond which no search goes, pixels.
inline constexpr double largest_displacement = 16.0;

/// How far a picture's objects are from where they belong: for each pixel the distance from its centre to the nearest
/// sub-sample of the truth with the same object id, in pixels, at the given share (0 to 1) of the sorted distances.
/// `objects`: one id a pixel; `true_objects`: the same view with 4 x 4 sub-samples a pixel, four times as wide and
/// high. An exact picture has sqrt(2)/8 = 0.177 everywhere.
double edge_displacement(const Picture& objects, const Picture& true_objects, double share);

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/render_frame.h"

namespace render {

/// Peak signal-to-noise ratio of two 8-bit pictures of one size, dB over all three colours; infinite when they are
/// equal. Throws std::invalid_argument for different sizes.
double peak_signal_to_noise(const content::Image& a, const content::Image& b);

/// CIEDE2000 of two pictures of radiance, pixel by pixel, as the truth's automatic exposure shows them; what is
/// brighter than the display's white counts as if exposed to it.
std::vector<double> colour_differences(const Picture& picture, const Picture& truth);

/// |a - b| four times enlarged, to look at.
content::Image difference_picture(const content::Image& a, const content::Image& b);

/// Edge displacement beyond which no search goes, pixels.
inline constexpr double largest_displacement = 16.0;

/// The object layer of the truth, to measure edges by.
struct TrueObjects {
    Picture at_centres;  ///< one id a pixel, by the ray through its centre
    Picture sub_samples; ///< the same view with 4 x 4 sub-samples a pixel, four times as wide and high
};

/// How far a picture's objects are from where they belong, in pixels, at the given share (0 to 1) of the sorted
/// distances of all pixels. A pixel's distance is 0 where its id is the truth's at its centre, else that from its
/// centre to the nearest sub-sample of the truth with the same id. (The centre counts by itself: what is seen edge-on
/// through it alone, no sub-sample meets.) `objects`: one id a pixel.
double edge_displacement(const Picture& objects, const TrueObjects& truth, double share);

} // namespace render

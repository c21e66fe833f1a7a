#pragma once

#include "render/colour/doppler_colour.h"

#include <vector>

namespace render {

/// M(D) of one picture, mode and pre-exposure baked in, over the D that the picture holds: what the shaders look up
/// (render/shaders/shared/colour.glsl). As a 1D array texture, RGBA32F, `samples` wide, three layers, linear filter,
/// clamped: layer i holds the light seen of linear RGB component i at rest, alpha 0. Linear in log2 D.
struct FrameColourTable {
    static constexpr int samples = 1024;
    static constexpr int layers = 3;

    std::vector<float> texels; ///< layers * samples * 4, layer by layer
    /// Texture coordinate = coordinate_scale * log2 D + coordinate_offset (sample centres).
    float coordinate_scale = 0.0f;
    float coordinate_offset = 0.5f;
};

/// Tabulates pre_exposure * M(D) for D in [smallest_ratio, largest_ratio] (0 < smallest <= largest; both are clamped to
/// [1e-4, 1e4]). Linear interpolation errs by less than 0.1 % of the light where that is within 1e-6 of the white at
/// rest, for ratios spanning up to e^9. About 0.2 ms.
FrameColourTable frame_colour_table(const DopplerColour& colour, Mode mode, double smallest_ratio, double largest_ratio,
                                    double pre_exposure);

} // namespace render

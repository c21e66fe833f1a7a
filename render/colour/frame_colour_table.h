#pragma once

#include "render/colour/scene_colour.h"

#include <vector>

namespace render {

/// The colours of one picture, mode and pre-exposure baked in, over the D that the picture holds: what the shaders look
/// up (render/shaders/shared/colour.glsl). As a 1D array texture, RGBA32F, `samples` wide, linear filter, clamped,
/// linear in log2 D. Each group of the scene's terms has layers of its own, from first_layer(group) on: layer i < 3
/// holds the light seen of the term i and in its alpha component i of the fourth term's; later terms have a layer each.
/// Of a group with hues every term has a layer of its own. Group 0, RGB radiance, has the first three.
struct FrameColourTable {
    static constexpr int samples = 1024;

    explicit FrameColourTable(const SceneSpectra& spectra);

    int layers() const { return layer_count; }
    std::size_t texel(int layer, int sample) const {
        return 4 * (static_cast<std::size_t>(layer) * samples + static_cast<std::size_t>(sample));
    }

    std::vector<int> first_layer; ///< by group
    int layer_count = 0;
    std::vector<float> texels; ///< layers * samples * 4, layer by layer
    /// Texture coordinate = coordinate_scale * log2 D + coordinate_offset (sample centres).
    float coordinate_scale = 0.0f;
    float coordinate_offset = 0.5f;
    /// What multiplies RGB under the scene's light, where mode and D leave its colour as it is; 0 where they do not.
    float plain_gain = 0.0f;
};

/// Layers that a group with this surface takes.
int layers_of(const SurfaceSpectrum& surface);

/// Tabulates pre_exposure * columns for D in [smallest_ratio, largest_ratio] (0 < smallest <= largest; both are clamped
/// to [1e-4, 1e4]). Linear interpolation errs by less than 0.1 % of the light where that is within 1e-6 of the white at
/// rest, for ratios spanning up to e^9. About 0.1 ms a group, 3 ms a group with hues.
FrameColourTable frame_colour_table(const SceneColour& colour, Mode mode, double smallest_ratio, double largest_ratio,
                                    double pre_exposure);

} // namespace render

#include "render/colour/frame_colour_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

FrameColourTable frame_colour_table(const DopplerColour& colour, Mode mode, double smallest_ratio, double largest_ratio,
                                    double pre_exposure) {
    const double ln_first = std::log(std::clamp(smallest_ratio, 1e-4, 1e4));
    // At rest all D are 1: a sliver of width keeps the coordinate finite.
    const double ln_last = std::max(std::log(std::clamp(largest_ratio, 1e-4, 1e4)), ln_first + 1e-3);
    const double step = (ln_last - ln_first) / (FrameColourTable::samples - 1);

    FrameColourTable table;
    table.texels.resize(static_cast<std::size_t>(FrameColourTable::layers) * FrameColourTable::samples * 4, 0.0f);
    for (int sample = 0; sample < FrameColourTable::samples; ++sample) {
        const glm::dmat3 matrix = pre_exposure * colour.matrix(mode, ln_first + sample * step);
        for (int layer = 0; layer < FrameColourTable::layers; ++layer) {
            const auto texel = static_cast<std::size_t>(4 * (layer * FrameColourTable::samples + sample));
            for (int component = 0; component < 3; ++component) {
                table.texels[texel + static_cast<std::size_t>(component)] =
                    static_cast<float>(matrix[layer][component]);
            }
        }
    }
    const double samples_per_log2 = std::numbers::ln2 / step;
    table.coordinate_scale = static_cast<float>(samples_per_log2 / FrameColourTable::samples);
    table.coordinate_offset = static_cast<float>((0.5 - ln_first / step) / FrameColourTable::samples);
    return table;
}

} // namespace render

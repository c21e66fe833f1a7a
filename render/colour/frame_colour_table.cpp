#include "render/colour/frame_colour_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

void store(const TermColumns& columns, std::size_t terms, double pre_exposure, int sample, int first_layer,
           FrameColourTable& table) {
    const auto put = [&](int layer, std::size_t component, double value) {
        table.texels[table.texel(layer, sample) + component] = static_cast<float>(pre_exposure * value);
    };
    for (std::size_t term = 0; term < terms; ++term) {
        for (std::size_t component = 0; component < 3; ++component) {
            const double value = columns.at(term)[static_cast<int>(component)];
            if (term == 3) {
                put(first_layer + static_cast<int>(component), 3, value);
            } else {
                put(first_layer + static_cast<int>(term < 3 ? term : term - 1), component, value);
            }
        }
    }
}

} // namespace

int layers_of_terms(std::size_t terms) {
    return static_cast<int>(terms <= 3 ? terms : std::max<std::size_t>(3, terms - 1));
}

FrameColourTable::FrameColourTable(const SceneSpectra& spectra) {
    for (const TermGroup& group : spectra.groups()) {
        first_layer.push_back(layer_count);
        layer_count += layers_of_terms(spectra.surfaces()[group.surface].count());
    }
}

FrameColourTable frame_colour_table(const SceneColour& colour, Mode mode, double smallest_ratio, double largest_ratio,
                                    double pre_exposure) {
    const double ln_first = std::log(std::clamp(smallest_ratio, 1e-4, 1e4));
    // At rest all D are 1: a sliver of width keeps the coordinate finite.
    const double ln_last = std::max(std::log(std::clamp(largest_ratio, 1e-4, 1e4)), ln_first + 1e-3);
    const double step = (ln_last - ln_first) / (FrameColourTable::samples - 1);

    const SceneSpectra& spectra = colour.spectra();
    FrameColourTable table(spectra);
    table.texels.resize(table.texel(table.layers(), 0), 0.0f);
    for (std::size_t group = 0; group < spectra.groups().size(); ++group) {
        const std::size_t terms = spectra.surfaces()[spectra.groups()[group].surface].count();
        for (int sample = 0; sample < FrameColourTable::samples; ++sample) {
            store(colour.columns(group, mode, ln_first + sample * step), terms, pre_exposure, sample,
                  table.first_layer[group], table);
        }
    }
    const double samples_per_log2 = std::numbers::ln2 / step;
    table.coordinate_scale = static_cast<float>(samples_per_log2 / FrameColourTable::samples);
    table.coordinate_offset = static_cast<float>((0.5 - ln_first / step) / FrameColourTable::samples);
    return table;
}

} // namespace render

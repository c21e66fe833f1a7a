#include "render/colour/frame_colour_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

/// Where the values of a group at one sample go.
class Sample {
  public:
    Sample(FrameColourTable& table, int first_layer, int sample, double pre_exposure)
        : table_(table), first_layer_(first_layer), sample_(sample), pre_exposure_(pre_exposure) {}

    void put(std::size_t layer, std::size_t component, double value) {
        table_.texels[table_.texel(first_layer_ + static_cast<int>(layer), sample_) + component] =
            static_cast<float>(pre_exposure_ * value);
    }
    void put(std::size_t layer, const glm::dvec3& light) {
        for (std::size_t component = 0; component < 3; ++component) {
            put(layer, component, light[static_cast<int>(component)]);
        }
    }

  private:
    FrameColourTable& table_;
    int first_layer_;
    int sample_;
    double pre_exposure_;
};

void store(const TermColumns& columns, std::size_t terms, Sample sample) {
    for (std::size_t term = 0; term < terms; ++term) {
        if (term == 3) {
            for (std::size_t component = 0; component < 3; ++component) {
                sample.put(component, 3, columns[3][static_cast<int>(component)]);
            }
        } else {
            sample.put(term < 3 ? term : term - 1, columns.at(term));
        }
    }
}

} // namespace

int layers_of(const SurfaceSpectrum& surface) {
    const std::size_t terms = surface.count();
    return static_cast<int>(surface.hues() > 0 || terms <= 3 ? terms : std::max<std::size_t>(3, terms - 1));
}

FrameColourTable::FrameColourTable(const SceneSpectra& spectra) {
    for (const TermGroup& group : spectra.groups()) {
        first_layer.push_back(layer_count);
        layer_count += layers_of(spectra.surfaces()[group.surface]);
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
        const SurfaceSpectrum& surface = spectra.surfaces()[spectra.groups()[group].surface];
        for (int sample = 0; sample < FrameColourTable::samples; ++sample) {
            const double ln_ratio = ln_first + sample * step;
            Sample here(table, table.first_layer[group], sample, pre_exposure);
            if (surface.hues() == 0) {
                store(colour.columns(group, mode, ln_ratio), surface.count(), here);
            }
            for (std::size_t hue = 0; hue < surface.hues(); hue += 2) {
                const TermColumns columns = colour.columns(group, mode, ln_ratio, hue);
                for (std::size_t i = 0; i < surface.mixed_count(); ++i) {
                    here.put(surface.mixed_term(i, hue), columns.at(i));
                }
            }
        }
    }
    table.plain_gain = mode == Mode::geometry ? static_cast<float>(pre_exposure) : 0.0f;
    const double samples_per_log2 = std::numbers::ln2 / step;
    table.coordinate_scale = static_cast<float>(samples_per_log2 / FrameColourTable::samples);
    table.coordinate_offset = static_cast<float>((0.5 - ln_first / step) / FrameColourTable::samples);
    return table;
}

} // namespace render

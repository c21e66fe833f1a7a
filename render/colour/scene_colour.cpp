#include "render/colour/scene_colour.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double least_ratio = 1e-4;
constexpr double greatest_ratio = 1e4;
constexpr double lumens_per_watt = 683.002; // of monochromatic light at 555 nm (SI)
constexpr double metres_per_nanometre = 1e-9;
/// Steps of ln D. Averages of reflectances over the breadth of the visible: 0.6 %, a third of the tables' rows of 10
/// nm. Lines, of which only the matching functions' rows of 5 nm are left: 0.2 %.
constexpr int average_stride = 6;
constexpr int line_stride = 2;

} // namespace

TermCorrection::TermCorrection(const SurfaceSpectrum& surface, const TermColumns& at_rest)
    : needed_(surface.rule != content::ReflectanceRule::own && surface.hues() == 0), count_(surface.count()) {
    if (!needed_) {
        return;
    }
    weights_from_rgb_ = glm::inverse(glm::dmat3(at_rest[0], at_rest[1], at_rest[2]));
    for (std::size_t i = 3; i < count_; ++i) {
        of_others_.at(i) = weights_from_rgb_ * at_rest.at(i);
    }
}

void TermCorrection::apply(TermColumns& columns) const {
    if (!needed_) {
        return;
    }
    const glm::dmat3 primaries(columns[0], columns[1], columns[2]);
    for (std::size_t i = 3; i < count_; ++i) {
        columns.at(i) -= primaries * of_others_.at(i);
    }
    const glm::dmat3 corrected = primaries * weights_from_rgb_;
    for (int i = 0; i < 3; ++i) {
        columns.at(static_cast<std::size_t>(i)) = corrected[i];
    }
}

TermWeights TermCorrection::uncorrected(TermWeights weights) const {
    if (!needed_) {
        return weights;
    }
    auto& values = weights.values;
    glm::dvec3 primaries = weights_from_rgb_ * glm::dvec3(values[0], values[1], values[2]);
    for (std::size_t i = 3; i < count_; ++i) {
        primaries -= values.at(i) * of_others_.at(i);
    }
    values[0] = primaries.r;
    values[1] = primaries.g;
    values[2] = primaries.b;
    return weights;
}

/// Samples every spectrum once, and sums up what is seen of them.
class SceneColour::Builder {
  public:
    explicit Builder(SceneColour& colour) : colour_(colour), lines_(observer_) {}

    Light light_of(const content::Spectrum& spectrum) const {
        Light light;
        const glm::dmat3& rgb_from_xyz = colour_.doppler_.white().rgb_from_xyz();
        if (const auto kelvin = spectrum.black_body_kelvin()) {
            light.ln_temperature = std::log(*kelvin);
            const LogXyz white = colour_.doppler_.black_bodies().at_ln(*light.ln_temperature);
            // The eye's adaptation changes luminance a little.
            light.ln_scale =
                -white.ln_y -
                std::log(content::luminance_of(rgb_from_xyz * glm::dvec3(white.x_over_y, 1.0, white.z_over_y)));
        } else {
            const StepRange tabulated{steps(least_ratio), steps(greatest_ratio)};
            light.seen = lines_.shifts(std::max(spectrum.shortest_nm(), 1e-3), std::min(spectrum.longest_nm(), 1e8));
            light.seen = {std::max(light.seen.first, tabulated.first), std::min(light.seen.last, tabulated.last)};
            const glm::dvec3 white = lines_.xyz(log_samples(lines_.emitted({0, 0}), spectrum), 0);
            light.ln_scale = -std::log(content::luminance_of(rgb_from_xyz * white));
        }
        return light;
    }

    TermTables tables(const TermGroup& group) const {
        const SurfaceSpectrum& surface = colour_.spectra_.surfaces()[group.surface];
        const content::Spectrum& spectrum = colour_.spectra_.lights()[group.light];
        const bool is_black_body = colour_.lights_[group.light].ln_temperature.has_value();
        const StepRange shifts =
            is_black_body ? lines_.shifts(surface.shortest_nm, surface.longest_nm) : colour_.lights_[group.light].seen;
        // Tables end at whole strides.
        const StepRange emitted = lines_.emitted({shifts.first - 4 * average_stride, shifts.last + 4 * average_stride});
        const LogSpectrum light = log_samples(emitted, spectrum);
        std::vector<LogSpectrum> terms;
        for (const std::size_t i : tabulated_terms(surface)) {
            terms.push_back(log_samples(emitted, [&](double nm) { return surface.at(i, nm); }));
        }
        return is_black_body ? shifted_averages(lines_, light, terms, shifts, average_stride)
                             : shifted_terms(lines_, light, terms, shifts, line_stride);
    }

  private:
    /// In the order of the tables, three each. An index beyond the terms stands for nothing.
    static std::vector<std::size_t> tabulated_terms(const SurfaceSpectrum& surface) {
        std::vector<std::size_t> terms;
        if (surface.hues() == 0) {
            for (std::size_t i = 0; i < surface.count(); ++i) {
                terms.push_back(i);
            }
            return terms;
        }
        terms = {0, surface.mixed_term(3, 0), surface.mixed_term(4, 0)};
        for (std::size_t hue = 0; hue < surface.hues(); hue += 2) {
            for (std::size_t next = hue; next <= hue + 2; ++next) {
                terms.push_back(surface.mixed_term(1, next));
            }
        }
        return terms;
    }

    static int steps(double ratio) { return static_cast<int>(std::lround(std::log(ratio) / ln_wavelength_step)); }

    SceneColour& colour_;
    Observer observer_;
    LogObserver lines_;
};

SceneColour::SceneColour(const content::SceneDesc& scene)
    : spectra_(scene), doppler_(static_cast<double>(scene.light_temperature)) {
    const Builder builder(*this);
    for (const content::Spectrum& spectrum : spectra_.lights()) {
        lights_.push_back(builder.light_of(spectrum));
    }
    if (spectra_.microwave_background()) {
        lights_[spectra_.groups()[*spectra_.microwave_background()].light].ln_scale =
            std::log(lumens_per_watt * metres_per_nanometre / night_luminance_unit);
    }
    for (const TermGroup& group : spectra_.groups()) {
        terms_.push_back(builder.tables(group));
    }
    corrections_.resize(spectra_.surfaces().size());
    for (std::size_t group = 0; group < spectra_.groups().size(); ++group) {
        if (spectra_.groups()[group].light == 0) {
            const std::size_t surface = spectra_.groups()[group].surface;
            corrections_[surface] = TermCorrection(spectra_.surfaces()[surface], uncorrected(group, 0.0, 0));
        }
    }
}

TermColumns SceneColour::uncorrected(std::size_t group, double ln_wavelength_ratio, std::size_t hue) const {
    const Light& light = lights_[spectra_.groups()[group].light];
    glm::dvec3 scale(1.0);
    if (light.ln_temperature) {
        const LogXyz seen = doppler_.black_bodies().at_ln(*light.ln_temperature - ln_wavelength_ratio);
        scale = std::exp(seen.ln_y + light.ln_scale) * glm::dvec3(seen.x_over_y, 1.0, seen.z_over_y);
    } else {
        if (ln_wavelength_ratio < light.seen.first * ln_wavelength_step ||
            ln_wavelength_ratio > light.seen.last * ln_wavelength_step) {
            return {};
        }
        scale = glm::dvec3(std::exp(light.ln_scale - 5.0 * ln_wavelength_ratio));
    }
    const glm::dmat3& to_rgb = doppler_.white().rgb_from_xyz();
    const TermTables& tables = terms_[group];
    TermColumns columns{};
    if (spectra_.surfaces()[spectra_.groups()[group].surface].hues() > 0) {
        const glm::dmat3 fixed = tables.front().at(ln_wavelength_ratio);
        const glm::dmat3 hues = tables.at(1 + hue / 2).at(ln_wavelength_ratio);
        const int first = static_cast<int>(hue % 2);
        std::size_t next = 0;
        for (const glm::dvec3& xyz : {fixed[0], hues[first], hues[first + 1], fixed[1], fixed[2]}) {
            columns.at(next++) = to_rgb * (scale * xyz);
        }
        return columns;
    }
    std::size_t next = 0;
    for (const UniformTable<glm::dmat3>& table : tables) {
        const glm::dmat3 xyz = table.at(ln_wavelength_ratio);
        for (int i = 0; i < 3 && next < most_surface_terms; ++i) {
            columns.at(next++) = to_rgb * (scale * xyz[i]);
        }
    }
    return columns;
}

TermColumns SceneColour::columns(std::size_t group, Mode mode, double ln_wavelength_ratio, std::size_t hue) const {
    const bool shifted = mode == Mode::doppler || mode == Mode::full;
    TermColumns columns = uncorrected(group, shifted ? ln_wavelength_ratio : 0.0, hue);
    corrections_[spectra_.groups()[group].surface].apply(columns);
    const bool beamed = mode == Mode::searchlight || mode == Mode::full;
    if (beamed != shifted) {
        const double factor = std::exp((beamed ? -4.0 : 4.0) * ln_wavelength_ratio);
        for (glm::dvec3& column : columns) {
            column *= factor;
        }
    }
    return columns;
}

glm::dvec3 SceneColour::seen(std::size_t group, const TermWeights& weights, Mode mode,
                             double ln_wavelength_ratio) const {
    const TermColumns of_terms = columns(group, mode, ln_wavelength_ratio, weights.hue);
    glm::dvec3 light(0.0);
    for (std::size_t i = 0; i < of_terms.size(); ++i) {
        light += weights.values.at(i) * of_terms.at(i);
    }
    return light;
}

} // namespace render

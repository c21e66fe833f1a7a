#include "render/offline/seen_colour.h"

#include "render/colour/colour_space.h"

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double step = 1e-3;
/// Beyond this D nothing is tabulated; such rays are summed one by one.
constexpr double largest_joined_ln_ratio = 9.3;

/// Calls sum(received nm, weighted matching functions) for a light seen at D: over 1 nm, lines between their bends.
template <class Sum>
void each_received(const Observer& observer, const content::Spectrum& light, double wavelength_ratio, const Sum& sum) {
    std::vector<double> bends = light.bends();
    if (bends.empty()) {
        observer.xyz_each(sum);
        return;
    }
    for (double& nm : bends) {
        nm *= wavelength_ratio;
    }
    observer.xyz_each(bends, sum);
}

} // namespace

SpectralColour::SpectralColour(const SceneSpectra& spectra) : spectra_(spectra) {
    const content::Spectrum& scene_light = spectra.lights().front();
    const glm::dvec3 white = observer_.xyz([&](double nm) { return scene_light.at(nm); });
    rgb_from_xyz_ = srgb_from_xyz() * bradford_adaptation(white / white.y, d65_xyz);
    for (const content::Spectrum& light : spectra.lights()) {
        glm::dvec3 at_rest(0.0);
        each_received(observer_, light, 1.0,
                      [&](double nm, const glm::dvec3& matching) { at_rest += light.at(nm) * matching; });
        const glm::dvec3 rgb = rgb_from_xyz_ * at_rest;
        scales_.push_back(1.0 / content::luminance_of(rgb));
    }
    if (spectra.microwave_background()) {
        // W sr^-1 m^-3 nm to cd/m^2 to the radiance unit of a night sky.
        scales_[spectra.groups()[*spectra.microwave_background()].light] = 683.002e-9 / night_luminance_unit;
    }
    corrections_.resize(spectra.surfaces().size());
    for (std::size_t group = 0; group < spectra.groups().size(); ++group) {
        const TermGroup& terms = spectra.groups()[group];
        if (terms.light == 0) {
            corrections_[terms.surface] = TermCorrection(spectra.surfaces()[terms.surface], uncorrected(group, 1.0, 0));
        }
    }
}

TermColumns SpectralColour::uncorrected(std::size_t group, double wavelength_ratio, std::size_t hue) const {
    const TermGroup& terms = spectra_.groups()[group];
    const SurfaceSpectrum& surface = spectra_.surfaces()[terms.surface];
    const content::Spectrum& light = spectra_.lights()[terms.light];
    TermColumns xyz{};
    const auto add = [&](double nm, const glm::dvec3& matching) {
        const double emitted_nm = nm / wavelength_ratio;
        const glm::dvec3 white = light.at(emitted_nm) * matching;
        for (std::size_t i = 0; i < surface.mixed_count(); ++i) {
            xyz.at(i) += surface.at(surface.mixed_term(i, hue), emitted_nm) * white;
        }
    };
    each_received(observer_, light, wavelength_ratio, add);
    const double scale = scales_[terms.light] * std::pow(wavelength_ratio, -5.0);
    for (glm::dvec3& column : xyz) {
        column = scale * (rgb_from_xyz_ * column);
    }
    return xyz;
}

TermColumns SpectralColour::columns(std::size_t group, Mode mode, double wavelength_ratio, std::size_t hue) const {
    const bool shifted = mode == Mode::doppler || mode == Mode::full;
    TermColumns result = uncorrected(group, shifted ? wavelength_ratio : 1.0, hue);
    corrections_[spectra_.groups()[group].surface].apply(result);
    double factor = 1.0;
    if (mode == Mode::doppler) {
        factor = std::pow(wavelength_ratio, 4.0);
    } else if (mode == Mode::searchlight) {
        factor = std::pow(wavelength_ratio, -4.0);
    }
    for (glm::dvec3& column : result) {
        column *= factor;
    }
    return result;
}

glm::dvec3 SpectralColour::seen(const RestLight& at_rest, double wavelength_ratio) const {
    glm::dvec3 sum(0.0);
    for (const RestLight::Part& part : at_rest.parts) {
        const TermColumns of_terms = columns(part.group, Mode::full, wavelength_ratio, part.weights.hue);
        for (std::size_t i = 0; i < of_terms.size(); ++i) {
            sum += part.weights.values.at(i) * of_terms.at(i);
        }
    }
    return sum;
}

double SpectralColour::emitted(const RestLight& at_rest, double wavelength_nm) const {
    const double white_at_560 = scales_.front() * spectra_.lights().front().at(560.0);
    double sum = 0.0;
    for (const RestLight::Part& part : at_rest.parts) {
        const TermGroup& terms = spectra_.groups()[part.group];
        const SurfaceSpectrum& surface = spectra_.surfaces()[terms.surface];
        const TermWeights weights = corrections_[terms.surface].uncorrected(part.weights);
        double reflectance = 0.0;
        for (std::size_t i = 0; i < surface.mixed_count(); ++i) {
            reflectance += weights.values.at(i) * surface.at(surface.mixed_term(i, weights.hue), wavelength_nm);
        }
        sum += scales_[terms.light] * reflectance * spectra_.lights()[terms.light].at(wavelength_nm);
    }
    return sum / white_at_560;
}

SeenColour::SeenColour(const content::SceneDesc& scene, const SceneSpectra& spectra, Mode mode, double largest_ln_ratio,
                       SpectralSums sums)
    : spectral_(spectra), mode_(mode), largest_ln_ratio_(std::min(largest_ln_ratio, largest_joined_ln_ratio)) {
    if (sums == SpectralSums::tables) {
        tables_.emplace(scene);
    }
    const bool shifted = mode == Mode::doppler || mode == Mode::full;
    for (std::size_t group = 0; group < spectra.groups().size(); ++group) {
        const SurfaceSpectrum& surface = spectra.surfaces()[spectra.groups()[group].surface];
        counts_.push_back(surface.mixed_count());
        if (!shifted) {
            at_rest_.emplace_back();
            for (std::size_t hue = 0; hue < std::max<std::size_t>(surface.hues(), 1); ++hue) {
                at_rest_.back().push_back(spectral_.columns(group, Mode::geometry, 1.0, hue));
            }
        }
        if (!shifted || sums != SpectralSums::joined) {
            continue;
        }
        if (surface.hues() > 0) {
            joined_.emplace_back();
            continue;
        }
        // One sample lies at D = 1, so that what is at rest keeps its colour exactly.
        const double steps = std::ceil(largest_ln_ratio_ / step) + 2.0;
        std::vector<TermColumns> columns;
        for (double i = -steps; i <= steps; i += 1.0) {
            columns.push_back(spectral_.columns(group, mode, std::exp(i * step)));
        }
        std::vector<UniformTable<glm::dmat3>> tables;
        for (std::size_t term = 0; term < counts_.back(); term += 3) {
            std::size_t next = 0;
            tables.emplace_back(-steps * step, steps * step, columns.size(), [&](double) {
                const TermColumns& c = columns[next++];
                return glm::dmat3(c.at(term), c.at(term + 1), c.at(term + 2));
            });
        }
        joined_.push_back(std::move(tables));
    }
}

TermColumns SeenColour::columns(std::size_t group, double wavelength_ratio, std::size_t hue) const {
    const double ln_ratio = std::log(wavelength_ratio);
    if (tables_) {
        return tables_->columns(group, mode_, ln_ratio, hue);
    }
    if (joined_.empty() || joined_[group].empty() || std::abs(ln_ratio) > largest_ln_ratio_ + step) {
        return spectral_.columns(group, mode_, wavelength_ratio, hue);
    }
    TermColumns columns{};
    for (std::size_t table = 0; table < joined_[group].size(); ++table) {
        const glm::dmat3 three = joined_[group][table].at(ln_ratio);
        for (int i = 0; i < 3; ++i) {
            columns.at(3 * table + static_cast<std::size_t>(i)) = three[i];
        }
    }
    return columns;
}

glm::dvec3 SeenColour::radiance(const RestLight& at_rest, double wavelength_ratio) const {
    glm::dvec3 sum(0.0);
    for (const RestLight::Part& part : at_rest.parts) {
        const std::size_t hue = part.weights.hue;
        const TermColumns of_terms =
            at_rest_.empty() ? columns(part.group, wavelength_ratio, hue) : at_rest_[part.group][hue];
        for (std::size_t i = 0; i < counts_[part.group]; ++i) {
            sum += part.weights.values.at(i) * of_terms.at(i);
        }
    }
    return mode_ == Mode::searchlight ? sum * std::pow(wavelength_ratio, -4.0) : sum;
}

} // namespace render

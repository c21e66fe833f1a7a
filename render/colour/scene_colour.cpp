#include "render/colour/scene_colour.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

constexpr double first_visible_nm = 360.0;
constexpr double last_visible_nm = 830.0;
constexpr double least_ratio = 1e-4;
constexpr double greatest_ratio = 1e4;
constexpr double lumens_per_watt = 683.002; // of monochromatic light at 555 nm (SI)
constexpr double metres_per_nanometre = 1e-9;
/// Steps of ln D: 0.6 %, a third of the tables' rows of 10 nm.
constexpr double table_step = 0.006;

std::size_t steps_over(double first, double last) {
    return std::max<std::size_t>(4, 2 + static_cast<std::size_t>((last - first) / table_step));
}

} // namespace

TermCorrection::TermCorrection(const SurfaceSpectrum& surface, const TermColumns& at_rest)
    : needed_(surface.rule != content::ReflectanceRule::own &&
              surface.rule != content::ReflectanceRule::dominant_wavelength),
      count_(surface.count()) {
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
    glm::dvec3 primaries = weights_from_rgb_ * glm::dvec3(weights[0], weights[1], weights[2]);
    for (std::size_t i = 3; i < count_; ++i) {
        primaries -= weights.at(i) * of_others_.at(i);
    }
    weights[0] = primaries.r;
    weights[1] = primaries.g;
    weights[2] = primaries.b;
    return weights;
}

SceneColour::SceneColour(const content::SceneDesc& scene)
    : spectra_(scene), doppler_(static_cast<double>(scene.light_temperature)) {
    const Observer observer;
    for (const content::Spectrum& spectrum : spectra_.lights()) {
        lights_.push_back(light_of(spectrum, observer));
    }
    if (spectra_.microwave_background()) {
        lights_[spectra_.groups()[*spectra_.microwave_background()].light].ln_scale =
            std::log(lumens_per_watt * metres_per_nanometre / night_luminance_unit);
    }
    for (const TermGroup& group : spectra_.groups()) {
        tabulate(group, observer);
    }
    corrections_.resize(spectra_.surfaces().size());
    for (std::size_t group = 0; group < spectra_.groups().size(); ++group) {
        if (spectra_.groups()[group].light == 0) {
            const std::size_t surface = spectra_.groups()[group].surface;
            corrections_[surface] = TermCorrection(spectra_.surfaces()[surface], uncorrected(group, 0.0));
        }
    }
}

SceneColour::Light SceneColour::light_of(const content::Spectrum& spectrum, const Observer& observer) const {
    Light light;
    if (const auto kelvin = spectrum.black_body_kelvin()) {
        light.ln_temperature = std::log(*kelvin);
        light.ln_scale = -doppler_.black_bodies().at_ln(light.ln_temperature).ln_y;
    } else {
        light.is_black_body = false;
        light.first_ln_ratio =
            std::log(std::clamp(first_visible_nm / spectrum.longest_nm(), least_ratio, greatest_ratio));
        light.last_ln_ratio =
            std::log(std::clamp(last_visible_nm / std::max(spectrum.shortest_nm(), 1e-3), least_ratio, greatest_ratio));
        // Lines are narrower than the tables of reflectances: steps of 0.1 %.
        const double range = light.last_ln_ratio - light.first_ln_ratio;
        light.xyz = UniformTable<glm::dvec3>(
            light.first_ln_ratio, light.last_ln_ratio, std::max<std::size_t>(4, static_cast<std::size_t>(range / 1e-3)),
            [&](double ln_ratio) {
                const double ratio = std::exp(ln_ratio);
                return observer.xyz([&](double nm) { return spectrum.at(nm / ratio); });
            });
    }
    // The eye's adaptation changes luminance a little.
    const glm::dvec3 rgb = doppler_.white().rgb_from_xyz() * white_xyz(light, 0.0);
    light.ln_scale -= std::log(content::luminance_of(rgb));
    return light;
}

glm::dvec3 SceneColour::white_xyz(const Light& light, double ln_wavelength_ratio) const {
    if (light.is_black_body) {
        const LogXyz seen = doppler_.black_bodies().at_ln(light.ln_temperature - ln_wavelength_ratio);
        return std::exp(seen.ln_y + light.ln_scale) * glm::dvec3(seen.x_over_y, 1.0, seen.z_over_y);
    }
    if (ln_wavelength_ratio < light.first_ln_ratio || ln_wavelength_ratio > light.last_ln_ratio) {
        return glm::dvec3(0.0);
    }
    return std::exp(light.ln_scale - 5.0 * ln_wavelength_ratio) * light.xyz.at(ln_wavelength_ratio);
}

void SceneColour::tabulate(const TermGroup& group, const Observer& observer) {
    const SurfaceSpectrum& surface = spectra_.surfaces()[group.surface];
    const content::Spectrum& light = spectra_.lights()[group.light];
    const double first = std::log(first_visible_nm / surface.longest_nm) - 0.01;
    const double last = std::log(last_visible_nm / surface.shortest_nm) + 0.01;
    std::vector<UniformTable<glm::dmat3>> tables;
    for (std::size_t term = 0; term < surface.count(); term += 3) {
        const std::size_t terms = std::min<std::size_t>(3, surface.count() - term);
        tables.emplace_back(first, last, steps_over(first, last), [&](double ln_ratio) {
            return observer.relative_xyz(
                terms, [&](std::size_t i, double nm) { return surface.at(term + i, nm); }, std::exp(ln_ratio), light);
        });
    }
    relative_xyz_.push_back(std::move(tables));
}

TermColumns SceneColour::uncorrected(std::size_t group, double ln_wavelength_ratio) const {
    const TermGroup& terms = spectra_.groups()[group];
    const glm::dvec3 white = white_xyz(lights_[terms.light], ln_wavelength_ratio);
    const glm::dmat3& to_rgb = doppler_.white().rgb_from_xyz();
    TermColumns columns{};
    std::size_t next = 0;
    for (const UniformTable<glm::dmat3>& table : relative_xyz_[group]) {
        const glm::dmat3 relative = table.at(ln_wavelength_ratio);
        for (int i = 0; i < 3 && next < most_surface_terms; ++i) {
            columns.at(next++) = to_rgb * (white * relative[i]);
        }
    }
    return columns;
}

TermColumns SceneColour::columns(std::size_t group, Mode mode, double ln_wavelength_ratio) const {
    const bool shifted = mode == Mode::doppler || mode == Mode::full;
    TermColumns columns = uncorrected(group, shifted ? ln_wavelength_ratio : 0.0);
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
    const TermColumns of_terms = columns(group, mode, ln_wavelength_ratio);
    glm::dvec3 light(0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        light += weights.at(i) * of_terms.at(i);
    }
    return light;
}

} // namespace render

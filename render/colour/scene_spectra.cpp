#include "render/colour/scene_spectra.h"

#include "content/spectrum_data.h"
#include "render/colour/colour_space.h"
#include "render/colour/observer.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace render {
namespace {

content::ReflectanceRule rule_of(content::ReflectanceModel model) {
    switch (model) {
    case content::ReflectanceModel::five_terms:
        return content::ReflectanceRule::five_terms;
    case content::ReflectanceModel::dominant_wavelength:
        return content::ReflectanceRule::dominant_wavelength;
    case content::ReflectanceModel::three_primaries:
        break;
    }
    return content::ReflectanceRule::three_primaries;
}

/// Wavelengths outside of which the terms of a rule do not change.
std::array<double, 2> varying_range(content::ReflectanceRule rule) {
    switch (rule) {
    case content::ReflectanceRule::five_terms:
    case content::ReflectanceRule::vegetation:
        return {300.0, 2500.0};
    case content::ReflectanceRule::dominant_wavelength:
        return {360.0, 830.0};
    case content::ReflectanceRule::three_primaries:
    case content::ReflectanceRule::own:
        break;
    }
    return {380.0, 730.0};
}

DominantWavelengths dominant_wavelengths_under(double light_temperature) {
    const LogXyz white = Observer().black_body(light_temperature);
    return dominant_wavelengths(content::Spectrum(content::BlackBody{light_temperature}),
                                srgb_from_xyz() * bradford_adaptation({white.x_over_y, 1.0, white.z_over_y}, d65_xyz));
}

} // namespace

double SurfaceSpectrum::at(std::size_t i, double wavelength_nm) const {
    if (i < terms.size()) {
        return terms[i].at(wavelength_nm);
    }
    if (i == terms.size()) {
        return ultraviolet ? content::ultraviolet_share(wavelength_nm) : 0.0;
    }
    return infrared ? content::infrared_share(wavelength_nm) : 0.0;
}

std::size_t SurfaceSpectrum::mixed_term(std::size_t i, std::size_t hue) const {
    const std::size_t wheel = hues();
    if (wheel == 0 || i == 0) {
        return i;
    }
    if (i <= 2) {
        return 1 + (hue + i - 1) % wheel;
    }
    return terms.size() + i - 3;
}

SceneSpectra::SceneSpectra(const content::SceneDesc& scene)
    : light_temperature_(static_cast<double>(scene.light_temperature)) {
    if (scene.reflectance_model == content::ReflectanceModel::dominant_wavelength) {
        dominant_wavelengths_ = dominant_wavelengths_under(light_temperature_);
    }
    lights_.emplace_back(content::BlackBody{light_temperature_});
    for (const content::Lamp& lamp : scene.lamps) {
        lamps_.push_back(lamp.spectrum ? light_index(*lamp.spectrum) : 0);
    }
    falling_lights_ = lights_.size();
    surface_index(content::ReflectanceRule::three_primaries, {}, nullptr);
    groups_.push_back({0, 0});
    for (const content::Material& material : scene.materials) {
        add_material(scene, material);
    }
    if (scene.microwave_background) {
        lights_.emplace_back(content::BlackBody{microwave_background_kelvin});
        microwave_background_ = group_index({lights_.size() - 1, white_surface()});
    }
}

std::size_t SceneSpectra::white_surface() {
    const auto white = std::find_if(surfaces_.begin(), surfaces_.end(), [](const SurfaceSpectrum& surface) {
        return surface.rule == content::ReflectanceRule::own && surface.shortest_nm == surface.longest_nm;
    });
    return white != surfaces_.end() ? static_cast<std::size_t>(white - surfaces_.begin())
                                    : surface_index(content::ReflectanceRule::own, {}, nullptr);
}

std::size_t SceneSpectra::group_index(const TermGroup& group) {
    const auto known = std::find_if(groups_.begin(), groups_.end(), [&](const TermGroup& other) {
        return group.light == other.light && group.surface == other.surface;
    });
    if (known != groups_.end()) {
        return static_cast<std::size_t>(known - groups_.begin());
    }
    groups_.push_back(group);
    return groups_.size() - 1;
}

std::size_t SceneSpectra::light_index(const content::Spectrum& light) {
    const auto kelvin = light.black_body_kelvin();
    if (kelvin) {
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            if (lights_[i].black_body_kelvin() == kelvin) {
                return i;
            }
        }
    }
    lights_.push_back(light);
    return lights_.size() - 1;
}

std::size_t SceneSpectra::surface_index(content::ReflectanceRule rule, const content::InvisibleBands& bands,
                                        const content::Material* owner) {
    const bool ultraviolet = bands.ultraviolet.has_value();
    const bool infrared = bands.infrared.has_value();
    if (rule != content::ReflectanceRule::own) {
        for (std::size_t i = 0; i < surfaces_.size(); ++i) {
            if (surfaces_[i].rule == rule && surfaces_[i].ultraviolet == ultraviolet &&
                surfaces_[i].infrared == infrared) {
                return i;
            }
        }
    }
    SurfaceSpectrum surface;
    surface.rule = rule;
    surface.ultraviolet = ultraviolet;
    surface.infrared = infrared;
    if (rule == content::ReflectanceRule::own) {
        // Of a material that reflects or emits by a spectrum of its own; without an owner, a perfect white.
        content::SampledSpectrum white{{555.0}, {1.0}, content::TabulatedSpectrum::Beyond::held};
        const bool given = owner != nullptr && owner->reflectance_spectrum;
        surface.terms.push_back({given ? *owner->reflectance_spectrum : content::Spectrum(white)});
        surface.shortest_nm = given ? 40.0 : 555.0;
        surface.longest_nm = given ? 12000.0 : 555.0;
    } else {
        for (content::Spectrum& term : terms_of(rule)) {
            surface.terms.push_back({std::move(term), ultraviolet, infrared});
        }
        const auto [shortest, longest] = varying_range(rule);
        surface.shortest_nm = ultraviolet ? std::min(shortest, 350.0) : shortest;
        surface.longest_nm = infrared ? std::max(longest, 770.0) : longest;
    }
    surfaces_.push_back(std::move(surface));
    return surfaces_.size() - 1;
}

void SceneSpectra::add_material(const content::SceneDesc& scene, const content::Material& material) {
    MaterialTerms terms;
    const bool own = material.reflectance_spectrum.has_value();
    if (!own) {
        terms.invisible_reflectance = material.invisible_reflectance;
    }
    const content::ReflectanceRule rule =
        own ? content::ReflectanceRule::own
            : (material.vegetation && scene.reflectance_model == content::ReflectanceModel::five_terms
                   ? content::ReflectanceRule::vegetation
                   : rule_of(scene.reflectance_model));
    if (!material.unlit) {
        terms.surface = surface_index(rule, terms.invisible_reflectance, own ? &material : nullptr);
        const auto known = std::find_if(materials_.begin(), materials_.end(), [&](const MaterialTerms& other) {
            return other.surface == terms.surface && other.reflected != 0;
        });
        if (known != materials_.end()) {
            terms.reflected = known->reflected;
        } else {
            terms.reflected = groups_.size();
            for (std::size_t light = 0; light < falling_lights_; ++light) {
                groups_.push_back({light, terms.surface});
            }
        }
    }
    TermGroup emitted{0, 0};
    if (material.emission_spectrum || material.emission_temperature) {
        emitted.light = light_index(material.emission_spectrum
                                        ? *material.emission_spectrum
                                        : content::Spectrum(content::BlackBody{*material.emission_temperature}));
        emitted.surface = white_surface();
    } else {
        terms.invisible_emission = material.invisible_emission;
        emitted.surface = surface_index(content::ReflectanceRule::three_primaries, terms.invisible_emission, nullptr);
    }
    terms.emitted = group_index(emitted);
    materials_.push_back(terms);
}

std::vector<content::Spectrum> SceneSpectra::terms_of(content::ReflectanceRule rule) const {
    return rule == content::ReflectanceRule::dominant_wavelength ? dominant_wavelengths_.terms
                                                                 : content::smooth_terms(rule);
}

TermWeights SceneSpectra::weights(const SurfaceSpectrum& surface, const glm::dvec3& reflectance,
                                  const glm::dvec3& light, const content::InvisibleBands& invisible,
                                  double invisible_light) const {
    const content::Coefficients visible = content::coefficients(surface.rule, reflectance, light);
    TermWeights result;
    std::copy(visible.begin(), visible.end(), result.values.begin());
    std::size_t first_invisible = surface.terms.size();
    if (surface.hues() > 0) {
        const content::Hue lit = content::hue_of(glm::clamp(reflectance, 0.0, 1.0) * light);
        const HueWheel::Beside beside = hue_wheel().beside(lit.sextants);
        result.hue = beside.hue;
        result.values[1] = (1.0 - beside.share) * lit.chroma;
        result.values[2] = beside.share * lit.chroma;
        first_invisible = 3;
    }
    if (surface.ultraviolet) {
        result.values.at(first_invisible) = static_cast<double>(*invisible.ultraviolet) * invisible_light;
    }
    if (surface.infrared) {
        result.values.at(first_invisible + 1) = static_cast<double>(*invisible.infrared) * invisible_light;
    }
    return result;
}

TermWeights SceneSpectra::reflected(const MaterialTerms& material, const glm::dvec3& reflectance,
                                    const glm::dvec3& light) const {
    return weights(surfaces_[material.surface], reflectance, light, material.invisible_reflectance,
                   content::luminance_of(light));
}

TermWeights SceneSpectra::emitted(const MaterialTerms& material, const glm::dvec3& emission) const {
    return weights(surfaces_[groups_[material.emitted].surface], glm::dvec3(1.0), emission, material.invisible_emission,
                   1.0);
}

} // namespace render

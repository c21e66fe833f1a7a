#pragma once

#include "content/scene_desc.h"
#include "render/colour/dominant_wavelength.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

/// What a scene's colours are made of: which lights shine, which kinds of surface send them on, in which spectral
/// terms. Plain bookkeeping, the same for the tables of the real-time methods and for the reference's integrals.
namespace render {

/// Temperature of the cosmic microwave background (Fixsen 2009), kelvin.
inline constexpr double microwave_background_kelvin = 2.725;

/// Luminance of radiance 1 where the sky of stars is shown, cd/m^2: a star of magnitude 0 gives 2.54e-6 lux and is
/// shown as light_of_magnitude_zero.
inline constexpr double night_luminance_unit = 2.54e-6 / 1e-4;

/// Terms that one reflectance mixes: those of its rule, then what it does in the invisible; in whole tables of three.
inline constexpr std::size_t most_surface_terms = (content::most_terms + 2 + 2) / 3 * 3;

/// How much of them. Of dominant wavelengths: of white, hue `hue` of the wheel and the next.
struct TermWeights {
    std::array<double, most_surface_terms> values{};
    std::size_t hue = 0;
};

/// Reflectances of a kind of surface: the rule's terms, then ultraviolet, then infrared. All are mixed, but of dominant
/// wavelengths (white, then all hues of the wheel) only white and two hues side by side.
struct SurfaceSpectrum {
    content::ReflectanceRule rule = content::ReflectanceRule::three_primaries;
    std::vector<content::ReflectanceTerm> terms;
    bool ultraviolet = false; ///< has a term of its own there
    bool infrared = false;
    double shortest_nm = 0.0; ///< all terms are constant below this,
    double longest_nm = 0.0;  ///< and above this

    bool invisible() const { return ultraviolet || infrared; }
    /// One that has a term of its own in one of the invisible bands has one, if empty, in the other.
    std::size_t count() const { return terms.size() + (invisible() ? 2 : 0); }
    /// Hues of the wheel among the terms; 0 where all terms are mixed.
    std::size_t hues() const { return rule == content::ReflectanceRule::dominant_wavelength ? terms.size() - 1 : 0; }
    /// How many terms are mixed at once, and which comes i-th.
    std::size_t mixed_count() const { return hues() > 0 ? count() - hues() + 2 : count(); }
    std::size_t mixed_term(std::size_t i, std::size_t hue) const;
    /// Reflectance of term i, invisible ones included.
    double at(std::size_t i, double wavelength_nm) const;
};

/// A light sent on by a kind of surface: what tables are made for.
struct TermGroup {
    std::size_t light = 0;
    std::size_t surface = 0;
};

/// How a material makes use of the groups.
struct MaterialTerms {
    std::size_t surface = 0;   ///< that reflects
    std::size_t reflected = 0; ///< group under the first light; under light k it is this + k
    std::size_t emitted = 0;   ///< group of what it emits
    content::InvisibleBands invisible_reflectance;
    content::InvisibleBands invisible_emission;
};

/// Ultraviolet and infrared: reflectance, emission; 0 where nothing is given.
inline glm::vec4 invisible_bands(const MaterialTerms& terms) {
    return {terms.invisible_reflectance.ultraviolet.value_or(0.0f), terms.invisible_reflectance.infrared.value_or(0.0f),
            terms.invisible_emission.ultraviolet.value_or(0.0f), terms.invisible_emission.infrared.value_or(0.0f)};
}

class SceneSpectra {
  public:
    explicit SceneSpectra(const content::SceneDesc& scene);

    /// The first is the scene's light; those that fall on surfaces come before those that are only emitted.
    const std::vector<content::Spectrum>& lights() const { return lights_; }
    std::size_t falling_lights() const { return falling_lights_; }
    const std::vector<SurfaceSpectrum>& surfaces() const { return surfaces_; }
    /// The first is RGB radiance: three primaries under the scene's light. Sky, unlit and plain emission use it.
    const std::vector<TermGroup>& groups() const { return groups_; }
    const std::vector<MaterialTerms>& materials() const { return materials_; }
    /// Of the hues whose dominant wavelengths are tabulated; without hues unless the scene is of that model.
    const HueWheel& hue_wheel() const { return dominant_wavelengths_.wheel; }
    /// Index into lights of each lamp's light.
    const std::vector<std::size_t>& lamps() const { return lamps_; }
    /// Group of the microwave background, in absolute radiance: its weight is 1.
    const std::optional<std::size_t>& microwave_background() const { return microwave_background_; }
    double light_temperature() const { return light_temperature_; }

    /// Weights in the material's group under some light, whose linear RGB is `light`.
    TermWeights reflected(const MaterialTerms& material, const glm::dvec3& reflectance, const glm::dvec3& light) const;
    /// Weights in group `material.emitted`.
    TermWeights emitted(const MaterialTerms& material, const glm::dvec3& emission) const;

  private:
    std::size_t light_index(const content::Spectrum& light);
    std::size_t white_surface();
    std::size_t group_index(const TermGroup& group);
    std::size_t surface_index(content::ReflectanceRule rule, const content::InvisibleBands& bands,
                              const content::Material* owner);
    void add_material(const content::SceneDesc& scene, const content::Material& material);
    std::vector<content::Spectrum> terms_of(content::ReflectanceRule rule) const;
    TermWeights weights(const SurfaceSpectrum& surface, const glm::dvec3& reflectance, const glm::dvec3& light,
                        const content::InvisibleBands& invisible, double invisible_light) const;

    double light_temperature_;
    DominantWavelengths dominant_wavelengths_;
    std::vector<content::Spectrum> lights_;
    std::size_t falling_lights_ = 1;
    std::vector<SurfaceSpectrum> surfaces_;
    std::vector<TermGroup> groups_;
    std::vector<MaterialTerms> materials_;
    std::vector<std::size_t> lamps_;
    std::optional<std::size_t> microwave_background_;
};

} // namespace render

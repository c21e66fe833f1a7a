#pragma once

#include "content/scene_desc.h"

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

/// Terms of a surface: those of its rule, then what it does in the invisible.
inline constexpr std::size_t most_surface_terms = content::most_terms + 2;
using TermWeights = std::array<double, most_surface_terms>;

/// Reflectances that a kind of surface mixes. Weights: the rule's coefficients, then ultraviolet, then infrared.
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

    double light_temperature_;
    std::vector<content::Spectrum> lights_;
    std::size_t falling_lights_ = 1;
    std::vector<SurfaceSpectrum> surfaces_;
    std::vector<TermGroup> groups_;
    std::vector<MaterialTerms> materials_;
    std::vector<std::size_t> lamps_;
    std::optional<std::size_t> microwave_background_;
};

} // namespace render

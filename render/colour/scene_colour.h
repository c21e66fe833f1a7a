#pragma once

#include "render/colour/doppler_colour.h"
#include "render/colour/log_spectrum.h"
#include "render/colour/scene_spectra.h"

#include <array>
#include <optional>
#include <vector>

namespace render {

/// Light seen of each of the terms that a surface mixes, per unit of weight: adapted linear RGB.
using TermColumns = std::array<glm::dvec3, most_surface_terms>;

/// Makes XYZ of a group's terms into columns: adapted to the scene's light, each light as bright on white as its RGB
/// says, and RGB given back at D = 1 exactly by rules that have primaries (the primaries' weights are corrected once
/// for the scene's light).
class TermCorrection {
  public:
    TermCorrection() = default;
    /// `at_rest`: columns at D = 1 under the scene's light, uncorrected.
    TermCorrection(const SurfaceSpectrum& surface, const TermColumns& at_rest);
    /// Corrected columns, in place.
    void apply(TermColumns& columns) const;
    /// The same for weights: those of the uncorrected terms that give the light of these.
    TermWeights uncorrected(TermWeights weights) const;

  private:
    bool needed_ = false;
    std::size_t count_ = 0;
    glm::dmat3 weights_from_rgb_{1.0};
    std::array<glm::dvec3, most_surface_terms> of_others_{}; ///< primaries' weights that cancel the others at D = 1
};

/// All colours of a scene under Doppler shift, from tables in ln D built once: under a black body, reflectances
/// averaged over what the eye sees of it, exactly constant where the terms are, times the black body's own colour at D;
/// under any other light, what the eye sees of it sent on by each term.
class SceneColour {
  public:
    explicit SceneColour(const content::SceneDesc& scene);

    const SceneSpectra& spectra() const { return spectra_; }
    /// RGB radiance under the scene's light, and black bodies.
    const DopplerColour& doppler() const { return doppler_; }

    /// Columns of group `group` at D, by mode: geometry as at D = 1; searchlight those times D^-4; doppler without the
    /// D^-4 of the total. Finite for D in [1e-4, 1e4]. `hue`: whose columns, of a group with hues.
    TermColumns columns(std::size_t group, Mode mode, double ln_wavelength_ratio, std::size_t hue = 0) const;

    /// Light seen of a group with these weights.
    glm::dvec3 seen(std::size_t group, const TermWeights& weights, Mode mode, double ln_wavelength_ratio) const;

  private:
    struct Light {
        std::optional<double> ln_temperature; ///< of a black body
        StepRange seen;                       ///< of any other: outside of these shifts nothing of it is seen
        double ln_scale = 0.0;                ///< so that white under it has luminance 1 at rest
    };
    class Builder;

    TermColumns uncorrected(std::size_t group, double ln_wavelength_ratio, std::size_t hue) const;

    SceneSpectra spectra_;
    DopplerColour doppler_;
    std::vector<Light> lights_;
    std::vector<TermTables> terms_; ///< by group: under a black body relative to white, under others XYZ times D^5
                                    ///< of hues: white and the invisible, then each even hue with the two after it
    std::vector<TermCorrection> corrections_; ///< by surface
};

} // namespace render

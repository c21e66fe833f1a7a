#pragma once

#include "render/colour/observer.h"
#include "render/colour/scene_colour.h"
#include "render/offline/rest_light.h"
#include "render/render_frame.h"

#include <optional>
#include <vector>

namespace render {

/// Light at D by integrals over the spectrum itself: L(lambda / D) D^-5 over 471 wavelengths, 1 nm apart (measured
/// lights: anew between all of their samples), in double precision, with no table between. The truth for SceneColour.
class SpectralColour {
  public:
    /// Keeps a reference: `spectra` must outlive this.
    explicit SpectralColour(const SceneSpectra& spectra);

    /// As SceneColour::columns.
    TermColumns columns(std::size_t group, Mode mode, double wavelength_ratio, std::size_t hue = 0) const;

    /// Linear RGB of light seen at D with every effect.
    glm::dvec3 seen(const RestLight& at_rest, double wavelength_ratio) const;
    /// Spectral radiance at rest of the light that `columns` sums, in units of a white's at 560 nm in the scene's
    /// light.
    double emitted(const RestLight& at_rest, double wavelength_nm) const;
    /// Adapted linear RGB of XYZ whose Y is 1 for the white at rest.
    const glm::dmat3& rgb_from_xyz() const { return rgb_from_xyz_; }

  private:
    TermColumns uncorrected(std::size_t group, double wavelength_ratio, std::size_t hue) const;

    const SceneSpectra& spectra_;
    Observer observer_;
    glm::dmat3 rgb_from_xyz_{1.0};
    std::vector<double> scales_; ///< by light: radiance to the scene's
    std::vector<TermCorrection> corrections_;
};

/// How a picture's spectra are summed.
enum class SpectralSums : std::uint8_t {
    joined, ///< at steps of 1e-3 in ln D over every D the eye can see, joined by cubics: adds less than 1e-5 of white;
            ///< dominant wavelengths, of which a ray mixes few of many, anew for every ray
    each_ray, ///< anew for every ray
    tables,   ///< not at all: by the tables of the real-time methods, to compare them with the truth on the same rays
};

/// Light at rest to radiance as seen at D, for one picture.
class SeenColour {
  public:
    /// `largest_ln_ratio`: |ln D| never exceeds it (the eye's rapidity).
    SeenColour(const content::SceneDesc& scene, const SceneSpectra& spectra, Mode mode, double largest_ln_ratio,
               SpectralSums sums);

    glm::dvec3 radiance(const RestLight& at_rest, double wavelength_ratio) const;

  private:
    TermColumns columns(std::size_t group, double wavelength_ratio, std::size_t hue) const;

    SpectralColour spectral_;
    std::optional<SceneColour> tables_;
    Mode mode_;
    double largest_ln_ratio_;
    std::vector<std::vector<TermColumns>> at_rest_;             ///< by group and hue, where spectra keep their shape
    std::vector<std::vector<UniformTable<glm::dmat3>>> joined_; ///< by group, three terms a table, over ln D
    std::vector<std::size_t> counts_;
};

} // namespace render

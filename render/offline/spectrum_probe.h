#pragma once

#include "content/scene_desc.h"
#include "render/offline/scenery_hits.h"
#include "render/render_frame.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace render {

/// What is seen at a point of a picture, and its light's spectrum.
struct ProbedLight {
    enum class Source : std::uint8_t { surface, sky, star };

    Source source = Source::sky;
    std::string object;              ///< name of the instance, "" for sky and stars
    std::string material;            ///< likewise
    double distance = 0.0;           ///< from the eye, in the world: metres to a surface, light-years to a star
    double star_temperature = 0.0;   ///< kelvin
    glm::dvec3 world_direction{0.0}; ///< unit, where the light comes from
    double wavelength_ratio = 1.0;   ///< D
    glm::dvec3 at_rest{0.0};         ///< linear sRGB of its radiance at rest; 0 for a star
    glm::dvec3 seen{0.0};            ///< linear sRGB of its radiance as seen, with every effect; 0 for a star
    /// Spectral radiance where it is emitted, of a wavelength in nm. Of surfaces and sky in units of a white's at 560
    /// nm at rest, of a star in units of its own surface's at 560 nm.
    std::function<double(double)> emitted;

    /// The same light as received: D^-5 of the emitted, at lambda / D (PHYSICS 5).
    double received(double wavelength_nm) const;
};

/// Points at a picture and tells the spectrum that the renderers make its colour of.
class SpectrumProbe {
  public:
    /// Keeps a reference: `scene` must outlive this. Throws sim::BadInput for a scene that Embree cannot hold.
    explicit SpectrumProbe(const content::SceneDesc& scene);

    /// At a point of the frame's picture, in pixels from its left and upper edges: the star nearest to it within four
    /// pixels where the sky is seen, else the surface or sky. The frame's mode changes nothing.
    ProbedLight at(const RenderFrame& frame, const glm::dvec2& pixel) const;

  private:
    std::optional<ProbedLight> star(const RenderFrame& frame, const glm::dvec2& pixel) const;

    const content::SceneDesc& scene_;
    SceneryHits scenery_;
    struct Spectra;
    std::shared_ptr<const Spectra> spectra_; ///< found lights outlive the probe
};

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/colour/scene_spectra.h"
#include "render/offline/scenery_hits.h"

#include <vector>

namespace render {

/// Light that leaves towards the eye as seen at rest in the world, by spectral terms.
struct RestLight {
    struct Part {
        std::size_t group = 0; ///< into SceneSpectra::groups
        TermWeights weights{};
    };
    std::vector<Part> parts;
};

/// Light of a surface:
///   L = reflectance (E_sun/pi max(0, n.s) visible + ambient (0.65 + 0.35 n.y) + sum_lamps I/pi max(0, n.l) visible
///   w(d)/d^2)
///       + emission,   w(d) = clamp(1 - (d/range)^4, 0, 1), d at least 0.05 m;   unlit: L = base colour.
/// Shadows of sun and lamps are traced. Each lamp's light is of its own spectrum.
RestLight surface_light(const content::SceneDesc& scene, const SceneSpectra& spectra, const SceneryHits& scenery,
                        const SurfaceHit& hit);

/// Light of the sky seen in the unit world direction: the panorama, bilinear, or the gradient; and the microwave
/// background where the scene has it.
RestLight sky_light(const content::SceneDesc& scene, const SceneSpectra& spectra, const glm::dvec3& direction);

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/offline/scenery_hits.h"
#include "render/offline/seen_colour.h"
#include "render/render_frame.h"

namespace render {

/// The truth for every other method: one ray per sample in double precision, from the picture through aberration into
/// the scenery at rest (PHYSICS 4), shaded there and coloured on the way back (PHYSICS 5).
class ReferenceRenderer {
  public:
    /// Keeps a reference: `scene` must outlive this.
    explicit ReferenceRenderer(const content::SceneDesc& scene) : scene_(scene), spectra_(scene), scenery_(scene) {}

    /// Light: the mean over samples_per_side^2 rays on a regular grid in each pixel, as radiance before any exposure.
    /// Other layers: the ray through the pixel's centre, never averaged. The same picture on any number of threads.
    Picture render(const RenderFrame& frame, int samples_per_side, SpectralSums sums = SpectralSums::joined) const;

  private:
    const content::SceneDesc& scene_;
    SceneSpectra spectra_;
    SceneryHits scenery_;
};

} // namespace render

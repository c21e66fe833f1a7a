#pragma once

#include "content/scene_desc.h"
#include "render/gl/renderer.h"
#include "render/offline/reference.h"

namespace engine {

/// A real-time picture beside the truth of the same view, both exposed and encoded alike.
struct ComparedPictures {
    content::Image shown;
    content::Image truth;
    double signal_to_noise = 0.0;   ///< dB over the 8-bit colours
    double edge_displacement = 0.0; ///< pixels, by object id, at the 99.9th percentile
};

/// Draws `frame` with the renderer and by supersampled rays, and compares. The truth decides the exposure, by
/// the frame's exposure settings. Needs the renderer's context current.
ComparedPictures compare_with_reference(render::Renderer& renderer, const render::ReferenceRenderer& reference,
                                        const render::RenderFrame& frame, int samples_per_side);

} // namespace engine

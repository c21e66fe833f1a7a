#pragma once

#include "content/scene_desc.h"
#include "render/gl/renderer.h"
#include "render/offline/compare.h"
#include "render/offline/reference.h"

namespace engine {

/// The truth of a view: its light, exposed and encoded, and its objects.
struct TrueView {
    render::RenderFrame frame;
    render::Exposure exposure; ///< fixed at what the frame's settings make of the truth
    content::Image light;
    render::TrueObjects objects;
};

/// `samples_per_side`: of the light, in each pixel.
TrueView true_view(const render::ReferenceRenderer& reference, const render::RenderFrame& frame, int samples_per_side);

/// A real-time picture beside the truth of the same view, both exposed and encoded alike.
struct ComparedPictures {
    content::Image shown;
    double signal_to_noise = 0.0;   ///< dB over the 8-bit colours
    double edge_displacement = 0.0; ///< pixels, by object id, at the 99.9th percentile
};

/// Draws the view with the renderer, light and objects at the frame's sharpness, and compares. Needs the renderer's
/// context current.
ComparedPictures compare_with_truth(render::Renderer& renderer, const TrueView& truth);

} // namespace engine

#include "engine/method_comparison.h"

#include "engine/picture_maker.h"
#include "render/offline/compare.h"
#include "render/shown_picture.h"

namespace engine {
namespace {

render::RenderFrame object_frame(render::RenderFrame frame, int points_per_side) {
    frame.layer = render::Layer::object;
    frame.eye.width *= points_per_side;
    frame.eye.height *= points_per_side;
    return frame;
}

} // namespace

ComparedPictures compare_with_reference(render::Renderer& renderer, const render::ReferenceRenderer& reference,
                                        const render::RenderFrame& frame, int samples_per_side) {
    ComparedPictures compared;
    const render::Picture truth = reference.render(frame, samples_per_side);
    render::Exposure exposure = frame.exposure;
    exposure.stops = static_cast<float>(render::exposure_stops(truth, frame.exposure));
    exposure.automatic = false;
    compared.truth = render::shown_picture(truth, exposure);
    compared.shown = render::shown_picture(radiance_picture(renderer, frame), exposure);
    compared.signal_to_noise = render::peak_signal_to_noise(compared.shown, compared.truth);

    const render::Picture objects = renderer.picture(object_frame(frame, 1));
    const render::Picture true_objects = reference.render(object_frame(frame, 4), 1);
    compared.edge_displacement = render::edge_displacement(objects, true_objects, 0.999);
    return compared;
}

} // namespace engine

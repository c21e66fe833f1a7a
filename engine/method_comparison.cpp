#include "engine/method_comparison.h"

#include "engine/picture_maker.h"
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

TrueView true_view(const render::ReferenceRenderer& reference, const render::RenderFrame& frame, int samples_per_side) {
    TrueView truth;
    truth.frame = frame;
    const render::Picture light = reference.render(frame, samples_per_side);
    truth.exposure = frame.exposure;
    truth.exposure.stops = static_cast<float>(render::exposure_stops(light, frame.exposure));
    truth.exposure.automatic = false;
    truth.light = render::shown_picture(light, truth.exposure);
    truth.objects = {reference.render(object_frame(frame, 1), 1), reference.render(object_frame(frame, 4), 1)};
    return truth;
}

ComparedPictures compare_with_truth(render::Renderer& renderer, const TrueView& truth) {
    ComparedPictures compared;
    compared.shown = render::shown_picture(radiance_picture(renderer, truth.frame), truth.exposure);
    compared.signal_to_noise = render::peak_signal_to_noise(compared.shown, truth.light);
    const render::Picture objects = renderer.picture(object_frame(truth.frame, 1));
    compared.edge_displacement = render::edge_displacement(objects, truth.objects, 0.999);
    return compared;
}

} // namespace engine

#include "engine/cockpit/scenery_light.h"

#include <glm/matrix.hpp>

#include <utility>

namespace engine {

void SceneryLight::look_around(render::Renderer& renderer, const render::RenderFrame& frame,
                               const sim::BoostAndRotation& vehicle, double exposure_stops) {
    const double scene_stops = render::stops_at_rest(exposure_stops, sim::split(frame.eye.world_from_head), frame.mode);
    const bool first = newer_.empty();
    for (int i = 0; first || i < views_a_frame; ++i) {
        if (taken_ == views_.size()) {
            motion_ = vehicle;
            views_ = render::surroundings_views(motion_, frame.mode);
            taken_ = 0;
        }
        const render::SurroundingsView& view = views_[taken_++];
        const render::RenderFrame small = render::surroundings_frame(frame, motion_, view, scene_stops);
        render::add_samples(view, renderer.small_picture(small), static_cast<double>(small.exposure.stops), gathering_);
        if (taken_ == views_.size()) {
            older_ = std::exchange(newer_, std::exchange(gathering_, {}));
            if (first) {
                older_ = newer_;
                break;
            }
        }
    }
}

render::LightFromAround SceneryLight::in_cabin(const sim::BoostAndRotation& cabin) const {
    const glm::dmat3 cabin_from_boosted = glm::transpose(cabin.boosted_from_head);
    const float share =
        views_.empty() ? 1.0f : static_cast<float>(taken_ % views_.size()) / static_cast<float>(views_.size());
    render::LightFromAround light;
    light.add(older_, cabin_from_boosted, 1.0f - share);
    light.add(newer_, cabin_from_boosted, share);
    return light;
}

} // namespace engine

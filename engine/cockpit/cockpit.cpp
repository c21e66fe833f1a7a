#include "engine/cockpit/cockpit.h"

#include <cmath>

namespace engine {

Cockpit::Cockpit(float panel_scale)
    : cabin_(content::generator::make_cabin()), cabin_light_(cabin_.mesh), pass_(cabin_), panel_(panel_scale) {}

void Cockpit::light(render::Renderer& renderer, const render::RenderFrame& frame,
                    const sim::Lorentz<sim::World, sim::Vehicle>& world_from_vehicle,
                    const glm::dquat& vehicle_from_cabin, double exposure_stops) {
    const sim::BoostAndRotation vehicle = sim::split({world_from_vehicle.spin});
    scenery_light_.look_around(renderer, frame, vehicle, exposure_stops);
    sim::BoostAndRotation cabin = vehicle;
    cabin.boosted_from_head = vehicle.boosted_from_head * glm::mat3_cast(vehicle_from_cabin);
    pass_.set_light(cabin_light_, scenery_light_.in_cabin(cabin));
}

void Cockpit::draw(const render::CabinView& view, const render::CabinExposure& exposure, unsigned target_framebuffer,
                   const render::Viewport& viewport) {
    pass_.draw(view, exposure, panel_.texture(), target_framebuffer, viewport);
}

render::CabinView cabin_view(const render::EyeView& eye, const glm::dvec3& head_metres,
                             const glm::dquat& cabin_from_head) {
    const double across = std::tan(0.5 * eye.horizontal_field_of_view);
    const double upwards = across * eye.height / eye.width;
    return {head_metres, cabin_from_head, {-across, across, -upwards, upwards}};
}

} // namespace engine

#include "engine/frame_builder.h"

namespace engine {
PictureSettings starting_picture(const content::Scenario& scenario) {
    PictureSettings picture;
    picture.exposure.automatic = scenario.exposure.automatic;
    picture.exposure.stops = static_cast<float>(scenario.exposure.stops);
    picture.exposure.linear_curve = false;
    picture.horizontal_field_of_view = scenario.horizontal_field_of_view;
    return picture;
}

render::RenderFrame build_frame(const Flight& flight, const sim::VehicleState& moment,
                                const glm::dquat& vehicle_from_head, const PictureSettings& picture,
                                double seconds_since_last_frame) {
    render::RenderFrame frame;
    frame.eye.position = sim::head_event(moment, flight.control().head_position).space * flight.metres_per_light_unit();
    frame.eye.world_from_head =
        sim::world_from_head(moment.world_from_vehicle, vehicle_from_head, flight.control().head_velocity);
    frame.eye.horizontal_field_of_view = picture.horizontal_field_of_view;
    frame.eye.width = picture.width;
    frame.eye.height = picture.height;
    frame.mode = picture.mode;
    frame.exposure = picture.exposure;
    frame.display = picture.display;
    frame.seconds_since_last_frame = seconds_since_last_frame;
    frame.sharpness = picture.sharpness;
    frame.metres_per_light_year = flight.speed_of_light() * content::julian_year_seconds;
    return frame;
}

} // namespace engine

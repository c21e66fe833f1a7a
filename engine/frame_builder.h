#pragma once

#include "engine/flight.h"
#include "render/render_frame.h"

#include <vector>

namespace engine {

/// What one pane of a picture shows.
struct Pane {
    render::Mode mode = render::Mode::full;
    render::View view = render::View::natural;
};

/// How the pilot wants the picture; nothing of it is physics.
struct PictureSettings {
    render::Mode mode = render::Mode::full;
    render::Display display;
    std::vector<Pane> other_panes; ///< of a split picture, beside the one that mode and display say
    render::Exposure exposure;
    double horizontal_field_of_view = 1.5707963267948966; ///< radians
    int width = 1280;                                     ///< pixels
    int height = 720;
    double sharpness = 1.0; ///< see RenderFrame
};

/// The picture settings that a scenario starts with.
PictureSettings starting_picture(const content::Scenario& scenario);

/// What the renderer needs for one picture: the ship at a moment (Flight::between) with a head in it.
/// `seconds_since_last_frame`: pilot's time, 0 for a picture on its own.
render::RenderFrame build_frame(const Flight& flight, const sim::VehicleState& moment,
                                const glm::dquat& vehicle_from_head, const PictureSettings& picture,
                                double seconds_since_last_frame);

} // namespace engine

#include "engine/fly/flight_metadata.h"

#include "engine/picture_request.h"
#include "sim/readings.h"

#include <glm/trigonometric.hpp>

#include <string>

namespace engine {

render::PictureMetadata flight_metadata(const content::Scenario& scenario, const Flight& flight,
                                        const sim::VehicleState& moment, const render::RenderFrame& frame,
                                        const std::vector<Pane>& panes, double exposure_stops) {
    const sim::Readings readings = sim::readings(moment);
    const double unit = scenario.clock_unit_seconds;
    render::PictureMetadata metadata{
        {"scenario", scenario.name},
        {"mode", name_of(frame.mode, mode_names)},
        {"beta", readings.beta},
        {"rapidity", readings.rapidity.value},
        {"heading", readings.motion_in_world},
        {"event_time_seconds", unit * sim::head_event(moment, flight.control().head_position).t},
        {"event_position_metres", frame.eye.position},
        {"ship_clock_seconds", unit * moment.ship_clock.value},
        {"horizontal_field_of_view_degrees", glm::degrees(frame.eye.horizontal_field_of_view)},
        {"exposure_stops", exposure_stops},
        {"effects_exact", std::string(exact_effects)},
    };
    add_display_metadata(metadata, frame, panes);
    return metadata;
}

} // namespace engine

#include "engine/fly/flight_metadata.h"

#include "engine/picture_request.h"
#include "sim/state_hash.h"

#include <fmt/format.h>
#include <string>

namespace engine {

render::PictureMetadata flight_metadata(const content::Scenario& scenario, const Flight& flight,
                                        const sim::VehicleState& moment, const render::RenderFrame& frame,
                                        const std::vector<Pane>& panes, double exposure_stops) {
    const double unit = scenario.clock_unit_seconds;
    render::PictureMetadata metadata{
        {"scenario", scenario.name},
        {"tick", static_cast<double>(flight.state().tick)},
        {"state_hash", fmt::format("{:016x}", sim::state_hash(flight.state()))},
        {"event_time_seconds", unit * sim::head_event(moment, flight.control().head_position).t},
        {"ship_clock_seconds", unit * moment.ship_clock.value},
        {"exposure_stops", exposure_stops},
    };
    add_eye_metadata(metadata, frame);
    add_display_metadata(metadata, frame, panes);
    return metadata;
}

} // namespace engine

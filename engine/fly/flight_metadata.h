#pragma once

#include "content/scenario.h"
#include "engine/flight.h"
#include "engine/panes.h"
#include "render/picture_file.h"
#include "render/render_frame.h"

#include <vector>

namespace engine {

/// What the file of a flight's picture says about it: scenario, the eye's event and motion at that moment, clocks,
/// display, and the flight's last tick with its state's hash, by which its recording is known. `frame`: of the whole
/// picture (build_frame); `exposure_stops`: those that the picture has.
render::PictureMetadata flight_metadata(const content::Scenario& scenario, const Flight& flight,
                                        const sim::VehicleState& moment, const render::RenderFrame& frame,
                                        const std::vector<Pane>& panes, double exposure_stops);

} // namespace engine

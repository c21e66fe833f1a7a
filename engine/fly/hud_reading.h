#pragma once

#include "content/scenario.h"
#include "engine/cameras/cameras.h"
#include "engine/flight.h"
#include "engine/frame_builder.h"
#include "engine/hud/hud_model.h"
#include "engine/navigation.h"

namespace engine {

/// What the instruments show of the ship at a moment, with a head in it. Frame rate, pace, pause and notices are the
/// caller's to add.
HudModel read_instruments(const content::Scenario& scenario, const Flight& flight, const sim::VehicleState& moment,
                          const glm::dquat& vehicle_from_head, const PictureSettings& picture,
                          const Navigation& navigation);

/// What changes on the instruments when `cameras` show the picture `frame`: other ships' clocks; and for a camera that
/// is not the pilot's its name and clock instead of marks that are the pilot's to see.
void add_cameras(const Cameras& cameras, const Flight& flight, const sim::VehicleState& moment,
                 const render::RenderFrame& frame, HudModel& model);

} // namespace engine

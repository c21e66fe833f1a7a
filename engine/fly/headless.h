#pragma once

#include "content/scenario.h"
#include "engine/fly/fly_options.h"

namespace engine {

/// Flies a script without a window and prints where it left the recording, the film and the stills. Without a script:
/// the scenario's demonstration. Throws sim::BadInput.
void fly_headless(const content::Scenario& scenario, FlyOptions options);

} // namespace engine

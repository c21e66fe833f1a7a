#pragma once

#include "content/scenario.h"
#include "engine/fly/fly_options.h"

namespace engine {

/// Flies in a headset without a window, by the headset's controllers, or by options.script at first. Ends after
/// options.seconds, when the headset's own menu ends it, or at Ctrl-C, and prints where the recording is. While the
/// headset is lost the flight stands still and waits for it. Throws input::XrFailure when there is no headset,
/// sim::BadInput for what cannot be loaded.
void fly_in_headset(const content::Scenario& scenario, const FlyOptions& options);

} // namespace engine

#pragma once

#include "content/scenario.h"

namespace engine {

/// Loads a scenario's scene and prints what was replaced or left out, a line each. Throws sim::BadInput.
content::SceneDesc loaded_scene(const content::Scenario& scenario);

} // namespace engine

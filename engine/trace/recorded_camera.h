#pragma once

#include "render/offline/traced/traced_scene.h"

#include <filesystem>
#include <vector>

namespace engine {

/// The ship of a recording as the camera of `frames` pictures, evenly over its ship time: its events in light clock
/// units are the chart's (the world's y is the chart's z), its motion that relative to the scenario's observer.
/// The recorded flight knew no gravity. Throws sim::BadInput.
std::vector<render::CameraPose> recorded_camera(const std::filesystem::path& recording, int frames);

} // namespace engine

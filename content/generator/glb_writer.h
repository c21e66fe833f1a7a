#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <vector>

namespace content::generator {

/// A scene as a binary glTF 2.0 file, all in one: meshes, materials, images (PNG), nodes, lamps (KHR_lights_punctual;
/// intensities as the scene's own units) and start views (cameras). Sky, stars and sun belong to the scenario and are
/// not written. The same scene gives the same bytes.
std::vector<std::uint8_t> glb_bytes(const SceneDesc& scene);

} // namespace content::generator

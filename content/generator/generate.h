#pragma once

#include "content/scene_desc.h"

#include <string>
#include <vector>

namespace content::generator {

/// The models that the program can make, in the order they are listed.
std::vector<std::string> model_names();

/// Makes a model: meshes, materials, images, instances and lamps; sky and sun belong to the scenario. The same every
/// time. Throws sim::BadInput when there is no model of that name.
SceneDesc generate_model(const std::string& name);

} // namespace content::generator

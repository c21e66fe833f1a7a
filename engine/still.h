#pragma once

#include "content/scene_desc.h"
#include "engine/picture_request.h"

namespace engine {

/// A still for a display: one picture, or panes beside each other, each exactly the single picture of its size; legend
/// and names over them as requested. Throws sim::BadInput when OpenGL cannot do it.
content::Image make_still(const content::SceneDesc& scene, const PictureRequest& request);

} // namespace engine

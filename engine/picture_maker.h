#pragma once

#include "content/scene_desc.h"
#include "engine/picture_request.h"

namespace engine {

/// Makes a picture of any layer by any method. Light is radiance, before any exposure. The OpenGL methods bring their
/// own context. Throws sim::BadInput when OpenGL cannot do it.
render::Picture make_picture(const content::SceneDesc& scene, const PictureRequest& request);

} // namespace engine

#pragma once

#include "content/scene_desc.h"
#include "engine/picture_request.h"
#include "render/gl/renderer.h"

namespace engine {

/// What automatic means on this machine: texture where OpenGL 4.5 runs on graphics hardware, else ray. Others stay.
PictureMethod chosen_method(PictureMethod method);

/// Makes a picture of any layer by any method but automatic. Light is radiance, before any exposure. The OpenGL methods
/// bring their own context. Throws sim::BadInput when OpenGL cannot do it.
render::Picture make_picture(const content::SceneDesc& scene, const PictureRequest& request);

/// A renderer's picture of any layer, light as radiance. The renderer's half floats hold light near the exposure it
/// picks for the frame; far below and above that they lose precision.
render::Picture radiance_picture(render::Renderer& renderer, render::RenderFrame frame);

} // namespace engine

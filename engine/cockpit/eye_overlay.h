#pragma once

#include "render/cabin/cabin_view.h"
#include "render/gl/renderer.h"

#include <functional>

namespace engine {

/// What is drawn over an eye's finished picture: the eye in the vehicle (cabin_from_eye: vehicle_from_eye), its frame,
/// and the exposure that its picture was shown by.
using EyeOverlay = std::function<void(const render::CabinView& eye_in_vehicle, const render::RenderFrame& frame,
                                      double exposure_stops, unsigned framebuffer, const render::Viewport& viewport)>;

} // namespace engine

#pragma once

#include "content/scene_desc.h"
#include "render/raycast/light_packets.h"
#include "render/raycast/packet_rays.h"

#include <array>

namespace render {

/// Radiance of the built-in sky into the wanted lanes.
void add_gradient_sky(const content::GradientSky& sky, const SeenPacket& seen, LaneMask wanted, Lanes3& light);

/// Levels of detail of a sky cube for each pixel (shared/sky_lod.glsl).
void sky_levels(float texels_per_pixel, const SeenPacket& seen, Lanes& levels);

/// To half floats, kept within their range; the fourth is 1 where the sky is seen.
void pack_halves(const Lanes3& light, LaneMask sky, std::array<HalfPixel, lane_count>& halves);

} // namespace render

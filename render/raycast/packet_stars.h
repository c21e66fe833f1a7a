#pragma once

#include "render/raycast/light_packets.h"
#include "render/star_sheet.h"
#include "render/stereo_share.h"

namespace render {

/// Adds the light of a frame's stars times `pre_exposure` to its packets, where these show the sky.
/// `share`: of both eyes of a headset; may be null.
void add_stars(const StarSheet& stars, const RenderFrame& frame, double pre_exposure, StereoShare* share,
               LightPackets& packets);

} // namespace render

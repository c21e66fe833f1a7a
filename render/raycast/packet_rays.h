#pragma once

#include "render/gl/boosted_view.h"
#include "render/offline/scenery_hits.h"
#include "render/raycast/lanes.h"

namespace render {

/// What sixteen pixels of the moving eye look at: a square of 4 x 4, row by row from the bottom.
struct SeenPacket {
    Lanes3 direction;       ///< unit, world
    Lanes wavelength_ratio; ///< D
    Lanes ray_length2;      ///< of the unnormalised eye ray: 1 / cos^2 of the angle off the screen's axis
};

/// Where pixels whose lower left corner is at (left, bottom) look, through their centres.
void see_packet(const ScreenRays& screen, int left, int bottom, SeenPacket& seen);

/// How much wider a pixel's cone gets in a metre of the world: its solid angle's root, 1/D as large as the eye's.
void spread_of(const SeenPacket& seen, float focal_pixels, Lanes& spread);

LaneMask lanes_with_hits(const PacketHits& hits);

} // namespace render

#pragma once

#include "render/raycast/light_packets.h"

namespace render {

/// What glare in the eye makes of a picture in packets, as bloomed() of a Picture. `result` is overwritten.
void add_glare(const LightPackets& packets, float share, LightPackets& result);

} // namespace render

#pragma once

#include "render/colour/auto_exposure.h"
#include "render/raycast/light_packets.h"

#include <cstdint>
#include <span>

namespace render {

/// How bright the picture is, by the squares of the display pass (LightMeter): whole ones only, at least one.
/// `pre_exposure`: what the light has been multiplied by.
MeteredLight metered(const LightPackets& packets, double pre_exposure);

/// How light is shown, besides false colours.
struct DisplaySettings {
    float exposure = 1.0f; ///< factor on the light
    bool linear_curve = true;
    float brightest = 1.0f; ///< see Display
    bool dither = true;
};

/// What a display is given, by the mathematics of the display pass (shared/display.glsl) sixteen pixels at a time: sRGB
/// in bytes red, green, blue, 255; width x height of them, rows from the bottom. The same bytes as display_bytes of
/// display_colour.
void show_packets(const LightPackets& packets, const DisplaySettings& settings, std::span<std::uint32_t> rgba);

} // namespace render

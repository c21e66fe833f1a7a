#pragma once

#include "render/colour/auto_exposure.h"
#include "render/raycast/light_packets.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <vector>

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

/// How a picture's bytes lie in memory: red, green, blue, 255, rows from the bottom, or otherwise.
struct ByteLayout {
    bool blue_first = false;
    bool from_top = false;
};

/// What a display is given, by the mathematics of the display pass (shared/display.glsl) sixteen pixels at a time.
class PacketDisplay {
  public:
    /// sRGB in bytes, `size` pixels of them; they stay until the next call. Where `size` is that of the packets, they
    /// are display_bytes of display_colour; else encoded colours are interpolated linearly before they become bytes.
    std::span<const std::uint32_t> show(const LightPackets& packets, const DisplaySettings& settings,
                                        const glm::ivec2& size, const ByteLayout& layout = {});

  private:
    void show_scaled(const glm::ivec2& from, const DisplaySettings& settings, const glm::ivec2& size,
                     const ByteLayout& layout);

    std::vector<Four> encoded_; ///< a picture to be scaled, rows from the bottom
    std::vector<std::uint32_t> bytes_;
};

} // namespace render

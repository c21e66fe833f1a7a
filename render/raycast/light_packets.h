#pragma once

#include "render/raycast/lanes.h"
#include "render/render_frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// Pixels along each side of a packet.
inline constexpr int packet_side = 4;

/// A pixel of light in half floats: red, green, blue, and how much of the sky is to be seen.
using HalfPixel = std::array<std::uint16_t, 4>;

/// A picture of light as it is cast: packets of 4 x 4 pixels, row by row from the bottom, and so are the pixels in
/// each. Linear RGB. Packets reach over the picture's right and upper edges; what they hold there is not shown.
struct LightPackets {
    int width = 0; ///< pixels
    int height = 0;
    std::vector<Lanes3> light;
    std::vector<LaneMask> sky; ///< where nothing stands before the sky

    /// Contents are lost.
    void resize(int picture_width, int picture_height);

    int columns() const { return (width + packet_side - 1) / packet_side; }
    int rows() const { return (height + packet_side - 1) / packet_side; }
    /// Of the packet that the pixel lies in; from the lower left corner.
    std::size_t packet(int x, int y) const {
        return static_cast<std::size_t>(y / packet_side) * static_cast<std::size_t>(columns()) +
               static_cast<std::size_t>(x / packet_side);
    }
};

/// As OpenGL takes light: half floats, kept below 60000, rows from the bottom; width x height.
void write_halves(const LightPackets& packets, std::span<HalfPixel> pixels);

/// Light times `factor`, 3 channels, rows from the top.
Picture light_picture(const LightPackets& packets, float factor);

} // namespace render

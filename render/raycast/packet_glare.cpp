#include "render/raycast/packet_glare.h"

#include "render/colour/scattered_light.h"

#include <algorithm>
#include <array>
#include <span>
#include <tbb/parallel_for.h>
#include <vector>

namespace render {
namespace {

/// A row of pixels, from the bottom.
void read_row(const LightPackets& packets, int row, std::span<Four> pixels) {
    const std::size_t first = packets.packet(0, row);
    const int lanes = packet_side * (row % packet_side);
    for (int x = 0; x < packets.width; ++x) {
        const Lanes3& light = packets.light[first + static_cast<std::size_t>(x / packet_side)];
        const int lane = lanes + x % packet_side;
        pixels[static_cast<std::size_t>(x)] = Four{light.x[lane], light.y[lane], light.z[lane], 0.0f};
    }
}

/// A packet's light mixed with what is around its pixels: rows of the picture, from its first pixel's column on.
void mix(const Lanes3& light, const std::array<const Four*, packet_side>& around, int columns, float share,
         Lanes3& result) {
    for (int i = 0; i < lane_count; ++i) {
        const Four& scattered =
            around[static_cast<std::size_t>(i / packet_side)][std::min(i % packet_side, columns - 1)];
        result.x[i] = mixed_with_glare(light.x[i], scattered[0], share);
        result.y[i] = mixed_with_glare(light.y[i], scattered[1], share);
        result.z[i] = mixed_with_glare(light.z[i], scattered[2], share);
    }
}

} // namespace

void add_glare(const LightPackets& packets, float share, LightPackets& result) {
    const glm::ivec2 size(packets.width, packets.height);
    if (BloomGrid(size).levels == 0) {
        result = packets;
        return;
    }
    const ScatteredLight scattered(size, [&](int row, std::span<Four> pixels) { read_row(packets, row, pixels); });
    result.resize(packets.width, packets.height);
    tbb::parallel_for(0, packets.rows(), [&](int row) {
        const auto width = static_cast<std::size_t>(packets.width);
        std::vector<Four> pixels(packet_side * width);
        std::array<const Four*, packet_side> first{};
        for (int y = 0; y < packet_side; ++y) {
            // Of a packet that reaches over the picture's edge the last row once more.
            const int inside = std::min(packet_side * row + y, packets.height - 1) - packet_side * row;
            first.at(static_cast<std::size_t>(y)) = &pixels[static_cast<std::size_t>(inside) * width];
            if (inside == y) {
                scattered.around(packet_side * row + y,
                                 std::span(pixels).subspan(static_cast<std::size_t>(y) * width, width));
            }
        }
        for (int left = 0; left < packets.width; left += packet_side) {
            const std::size_t packet = packets.packet(left, packet_side * row);
            mix(packets.light[packet], first, std::min(packet_side, packets.width - left), share, result.light[packet]);
            for (const Four*& pixel : first) {
                pixel += packet_side;
            }
        }
    });
    result.sky = packets.sky;
}

} // namespace render

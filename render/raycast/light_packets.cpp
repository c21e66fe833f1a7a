#include "render/raycast/light_packets.h"

#include "render/raycast/packet_colour.h"

#include <algorithm>
#include <tbb/parallel_for.h>

namespace render {
namespace {

/// Calls put(lane, x, y) for the pixels of a packet that are inside the picture.
template <class Put>
void for_each_pixel(const LightPackets& packets, int column, int row, const Put& put) {
    const int left = column * packet_side;
    const int bottom = row * packet_side;
    for (int y = bottom; y < std::min(bottom + packet_side, packets.height); ++y) {
        for (int x = left; x < std::min(left + packet_side, packets.width); ++x) {
            put(packet_side * (y - bottom) + x - left, x, y);
        }
    }
}

/// Calls work(column, row) for every packet, rows of them on all processors.
template <class Work>
void for_each_packet(const LightPackets& packets, const Work& work) {
    tbb::parallel_for(0, packets.rows(), [&](int row) {
        for (int column = 0; column < packets.columns(); ++column) {
            work(column, row);
        }
    });
}

} // namespace

void LightPackets::resize(int picture_width, int picture_height) {
    width = picture_width;
    height = picture_height;
    const std::size_t count = static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    light.resize(count);
    sky.resize(count);
}

void write_halves(const LightPackets& packets, std::span<HalfPixel> pixels) {
    for_each_packet(packets, [&](int column, int row) {
        const std::size_t packet = packets.packet(packet_side * column, packet_side * row);
        std::array<HalfPixel, lane_count> halves;
        pack_halves(packets.light[packet], packets.sky[packet], halves);
        for_each_pixel(packets, column, row, [&](int lane, int x, int y) {
            pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(packets.width) +
                   static_cast<std::size_t>(x)] = halves[static_cast<std::size_t>(lane)];
        });
    });
}

Picture light_picture(const LightPackets& packets, float factor) {
    Picture picture{packets.width, packets.height, 3, {}};
    picture.values.resize(3 * static_cast<std::size_t>(packets.width) * static_cast<std::size_t>(packets.height));
    for_each_packet(packets, [&](int column, int row) {
        const Lanes3& light = packets.light[packets.packet(packet_side * column, packet_side * row)];
        for_each_pixel(packets, column, row, [&](int lane, int x, int y) {
            float* const value = &picture.values[3 * (static_cast<std::size_t>(packets.height - 1 - y) *
                                                          static_cast<std::size_t>(packets.width) +
                                                      static_cast<std::size_t>(x))];
            value[0] = factor * light.x[lane];
            value[1] = factor * light.y[lane];
            value[2] = factor * light.z[lane];
        });
    });
    return picture;
}

} // namespace render

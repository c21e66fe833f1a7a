#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace render {

/// What a traced picture holds for each pixel, as floats.
enum class TracedChannel : std::uint8_t {
    red, ///< radiance, linear sRGB
    green,
    blue,
    error,            ///< error estimate of its first ray, radians of the direction where it ends
    steps,            ///< mean number of steps of its rays
    wavelength_ratio, ///< D = lambda_seen / lambda_emitted of the ray through its middle; 0 where nothing is seen
    outcome,          ///< of that ray: RayFate as a number
    undecided,        ///< share of its rays that ran out of steps, left the chart or were not finite
    rays,             ///< how many were traced
};
inline constexpr std::size_t traced_channel_count = 9;
/// As OpenEXR files name them.
inline constexpr std::array<std::string_view, traced_channel_count> traced_channel_names{
    "R", "G", "B", "error", "steps", "wavelength_ratio", "outcome", "undecided", "rays"};

/// A rectangle of a traced picture: `values` holds traced_channel_count floats a pixel, rows from the top.
struct TracedTile {
    int left = 0; ///< pixels, in the picture
    int top = 0;
    int width = 0;
    int height = 0;
    std::vector<float> values;

    float& value(int column, int row, TracedChannel channel) {
        return values[(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)) *
                          traced_channel_count +
                      static_cast<std::size_t>(channel)];
    }
};

} // namespace render

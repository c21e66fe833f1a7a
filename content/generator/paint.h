#pragma once

#include "content/scene_desc.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

/// Textures painted by functions of a point. Colours here are sRGB-encoded in [0, 1], as an artist picks them; points
/// are in pictures, x to the right, y up, both in [0, 1]; every picture repeats, so patterns close at its edges.
namespace content::generator {

/// An sRGB colour written 0xRRGGBB, encoded.
constexpr glm::vec3 encoded(std::uint32_t hex) {
    return glm::vec3(static_cast<float>((hex >> 16U) & 0xffU), static_cast<float>((hex >> 8U) & 0xffU),
                     static_cast<float>(hex & 0xffU)) /
           255.0f;
}

/// The same, linear: what vertex colours, base colours and lights are given in.
glm::vec3 linear(std::uint32_t hex);

/// How much of a texel lies inside an outline: 1 inside, 0 outside, with an edge one texel wide. `distance`: signed
/// distance to the outline, negative inside; `texel`: a texel's width in the same unit.
inline float coverage(float distance, float texel) {
    return std::clamp(0.5f - distance / texel, 0.0f, 1.0f);
}

/// Signed distance to a box with rounded corners.
inline float box_distance(const glm::vec2& point, const glm::vec2& centre, const glm::vec2& half_size,
                          float rounding = 0.0f) {
    const glm::vec2 outside = glm::abs(point - centre) - half_size + rounding;
    return glm::length(glm::max(outside, 0.0f)) + std::min(std::max(outside.x, outside.y), 0.0f) - rounding;
}

/// Signed distance to a disk.
inline float disk_distance(const glm::vec2& point, const glm::vec2& centre, float radius) {
    return glm::length(point - centre) - radius;
}

/// A random number in [0, 1) that depends on the two integers and the seed alone.
float random_at(int x, int y, std::uint32_t seed);

/// Smooth noise in [0, 1] with `cells` cells a picture in each direction; repeats with the picture. Point >= 0.
float noise(const glm::vec2& point, const glm::ivec2& cells, std::uint32_t seed);

/// Noise of `octaves` octaves, each twice as fine and half as strong; in [0, 1], repeats with the picture.
float clouds(const glm::vec2& point, const glm::ivec2& cells, int octaves, std::uint32_t seed);

/// A picture of `width` x `height` texels; `colour_at(point)` gives a vec3 (opaque) or vec4 for each texel's centre.
template <typename ColourAt>
Image paint(std::string name, int width, int height, const ColourAt& colour_at) {
    Image image{std::move(name), width, height, {}};
    image.rgba.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const glm::vec2 point{(static_cast<float>(column) + 0.5f) / static_cast<float>(width),
                                  1.0f - (static_cast<float>(row) + 0.5f) / static_cast<float>(height)};
            glm::vec4 colour(1.0f);
            if constexpr (requires { glm::vec4(colour_at(point), 1.0f); }) {
                colour = glm::vec4(colour_at(point), 1.0f);
            } else {
                colour = colour_at(point);
            }
            for (int channel = 0; channel < 4; ++channel) {
                image.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(colour[channel], 0.0f, 1.0f))));
            }
        }
    }
    return image;
}

} // namespace content::generator

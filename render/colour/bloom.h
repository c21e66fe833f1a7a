#pragma once

#include "render/render_frame.h"

#include <glm/vec2.hpp>

namespace render {

/// Share of its light that a level of the pyramid takes from the next coarser one: what falls off as 1 / angle^2 has as
/// much light from each octave of angles as from the next, but is not endless.
inline constexpr float bloom_spread = 0.7f;

/// The grid of the bloom's pyramid: level 1, the finest, has cells between one and two pixels long; each next level has
/// half as many on a side. Every level covers the whole picture exactly, whatever its size.
struct BloomGrid {
    int levels = 0; ///< 0: a picture of less than four pixels on a side, which has no room to scatter in
    glm::ivec2 finest{0};

    explicit BloomGrid(const glm::ivec2& picture);
    /// Cells of level 1 to `levels`.
    glm::ivec2 cells(int level) const { return {finest.x >> (level - 1), finest.y >> (level - 1)}; }
};

/// A pixel's light and what is scattered around there.
inline float mixed_with_glare(float light, float around, float share) {
    return light + share * (around - light);
}

/// What glare in the eye makes of a picture of light (3 channels): `share` of every pixel's light is spread around it,
/// about as much over each octave of distance. The sum of the light stays, edges included.
Picture bloomed(const Picture& light, float share);

} // namespace render

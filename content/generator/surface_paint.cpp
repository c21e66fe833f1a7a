#include "content/generator/surface_paint.h"

#include "content/generator/paint.h"

#include <algorithm>

namespace content::generator {
namespace {

glm::vec3 asphalt_colour(const glm::vec2& point) {
    const float grain = random_at(static_cast<int>(point.x * 512.0f), static_cast<int>(point.y * 512.0f), 5);
    const float patches = clouds(point, {4, 4}, 5, 7);
    return encoded(0x6a6866) * (0.82f + 0.25f * patches + 0.10f * (grain - 0.5f));
}

// 8 m x 8 m of road: gutters, worn wheel tracks and a dashed centre line; x across, y along.
glm::vec3 road_colour(const glm::vec2& point) {
    constexpr float texel = 8.0f / 512.0f;
    glm::vec3 colour = asphalt_colour(point);
    const glm::vec2 p = point * 8.0f;
    const float track = std::abs(std::abs(p.x - 4.0f) - 1.7f);
    colour *= 0.93f + 0.07f * glm::smoothstep(0.2f, 0.9f, std::abs(track - 0.7f));
    const float edge = std::min(p.x, 8.0f - p.x);
    colour = glm::mix(colour, encoded(0x8d867b), 0.7f * coverage(edge - 0.35f, texel));
    const float joint = std::min(std::abs(edge - 0.36f), edge < 0.35f ? std::abs(glm::fract(p.y / 0.5f) - 0.5f) : 1.0f);
    colour = glm::mix(colour, encoded(0x4b4845), 0.6f * coverage(joint - 0.02f, texel * 2.0f));
    const float dash = box_distance(p, {4.0f, 2.0f}, {0.07f, 1.5f});
    const float wear = 0.55f + 0.4f * clouds(point, {32, 32}, 3, 9);
    return glm::mix(colour, encoded(0xe9e6dd), wear * coverage(dash, texel));
}

// Bars along the road, 0.5 m wide every metre; the picture is 8 m wide and 4 m long.
glm::vec3 zebra_colour(const glm::vec2& point) {
    constexpr float texel = 8.0f / 512.0f;
    const glm::vec3 colour = asphalt_colour(point);
    const glm::vec2 p = point * glm::vec2(8.0f, 4.0f);
    const float bar = box_distance({glm::fract(p.x), p.y}, {0.5f, 2.0f}, {0.27f, 1.7f});
    const float wear = 0.70f + 0.35f * clouds(point, {24, 12}, 3, 13);
    return glm::mix(colour, encoded(0xefece4), std::min(1.0f, wear) * coverage(bar, texel));
}

glm::vec3 paving_colour(const glm::vec2& point) {
    const glm::vec2 p = point * glm::vec2(6.0f, 4.0f); // slabs
    const float row = std::floor(p.y);
    const float shift = std::fmod(row, 2.0f) * 0.5f;
    const glm::vec2 slab{p.x + shift, p.y};
    const glm::ivec2 index(glm::floor(slab));
    const float shade = random_at(index.x % 6, index.y, 17);
    const glm::vec3 base =
        glm::mix(encoded(0xb7aa97), encoded(0xa39c92), shade) * (0.9f + 0.16f * clouds(point, {8, 8}, 4, 19));
    const float inside = box_distance(glm::fract(slab), glm::vec2(0.5f), glm::vec2(0.478f), 0.04f);
    return glm::mix(encoded(0x6f675c), base, coverage(inside, 6.0f / 512.0f));
}

glm::vec3 stone_colour(const glm::vec2& point) {
    return glm::vec3(0.86f + 0.13f * clouds(point, {8, 8}, 5, 29));
}

// Courses of dressed blocks; neutral.
glm::vec3 ashlar_colour(const glm::vec2& point) {
    const glm::vec2 p = point * glm::vec2(5.0f, 8.0f);
    const float row = std::floor(p.y);
    const glm::vec2 block{p.x + 0.5f * std::fmod(row, 2.0f), p.y};
    const glm::ivec2 index(glm::floor(block));
    const float shade = random_at(index.x % 5, index.y, 33);
    const float face = (0.80f + 0.14f * shade) * (0.9f + 0.14f * clouds(point, {6, 6}, 5, 35));
    const glm::vec2 in_block = (glm::fract(block) - 0.5f) / glm::vec2(5.0f, 8.0f);
    const float inside = box_distance(in_block, glm::vec2(0.0f), 0.5f / glm::vec2(5.0f, 8.0f) - 0.003f, 0.004f);
    return glm::vec3(glm::mix(0.62f, face, coverage(inside, 2.0f / 512.0f)));
}

// Neutral, so that a tint can colour it.
glm::vec3 plaster_colour(const glm::vec2& point) {
    const float grain = clouds(point, {24, 24}, 3, 53);
    const float stains = clouds(point, {3, 2}, 4, 59);
    const float streaks = clouds(point, {20, 2}, 3, 61);
    return glm::vec3(0.82f + 0.07f * grain + 0.10f * stains + 0.05f * streaks);
}

glm::vec3 brick_colour(const glm::vec2& point) {
    constexpr glm::vec2 bricks{8.0f, 24.0f}; // 2 m a picture
    const glm::vec2 p = point * bricks;
    const float row = std::floor(p.y);
    const glm::vec2 brick{p.x + 0.5f * std::fmod(row, 2.0f), p.y};
    const glm::ivec2 index(glm::floor(brick));
    const float shade = random_at(index.x % 8, index.y, 67);
    const glm::vec3 base = glm::mix(glm::vec3(0.98f, 0.90f, 0.86f), glm::vec3(0.72f, 0.66f, 0.66f), shade);
    const glm::vec2 in_brick = (glm::fract(brick) - 0.5f) / bricks; // pictures
    const float inside = box_distance(in_brick, glm::vec2(0.0f), 0.5f / bricks - 0.0035f, 0.002f);
    return glm::mix(glm::vec3(1.0f, 0.98f, 0.95f), base, coverage(inside, 1.5f / 512.0f)) *
           (0.9f + 0.12f * clouds(point, {6, 6}, 4, 73));
}

// Rows of rounded tiles, 2 m a picture; neutral.
glm::vec3 roof_colour(const glm::vec2& point) {
    const glm::vec2 p = point * glm::vec2(10.0f, 8.0f);
    const float row = std::floor(p.y);
    const glm::vec2 tile{p.x + 0.5f * std::fmod(row, 2.0f), p.y};
    const glm::vec2 inside = glm::fract(tile);
    const float shade = random_at(static_cast<int>(std::floor(tile.x)) % 10, static_cast<int>(row), 79);
    const float rounding = 4.0f * (inside.x - 0.5f) * (inside.x - 0.5f);
    const float lip = glm::smoothstep(0.0f, 0.22f, inside.y - 0.16f * rounding);
    const float groove = 1.0f - 0.35f * glm::smoothstep(0.75f, 1.0f, rounding);
    const float moss = clouds(point, {3, 3}, 4, 83);
    return glm::vec3((0.74f + 0.22f * shade) * (0.5f + 0.5f * lip) * groove * (0.86f + 0.2f * moss));
}

glm::vec3 bark_colour(const glm::vec2& point) {
    return encoded(0x6b5744) * (0.65f + 0.6f * clouds(point, {12, 3}, 4, 89));
}

// Clumps of leaves with gaps between them.
glm::vec4 leaf_colour(const glm::vec2& point) {
    const float clumps = clouds(point, {5, 5}, 3, 97);
    const float leaves = clouds(point, {30, 30}, 2, 101);
    const glm::vec3 colour = glm::mix(encoded(0x4b5b2a), encoded(0x93a25a), glm::smoothstep(0.28f, 0.75f, leaves));
    const float cover = 0.55f * clumps + 0.45f * leaves;
    return {colour * (0.88f + 0.3f * clumps), std::clamp(0.5f + 9.0f * (cover - 0.41f), 0.0f, 1.0f)};
}

glm::vec3 grass_colour(const glm::vec2& point) {
    const float patches = clouds(point, {5, 5}, 5, 103);
    return glm::mix(encoded(0x5c6a36), encoded(0x8d8f52), patches) * (0.9f + 0.15f * noise(point, {90, 90}, 107));
}

} // namespace

Image asphalt_image() {
    return paint("asphalt", 512, 512, asphalt_colour);
}

Image road_image() {
    return paint("road", 512, 512, road_colour);
}

Image zebra_image() {
    return paint("zebra crossing", 512, 256, zebra_colour);
}

Image paving_image() {
    return paint("paving", 512, 512, paving_colour);
}

Image ashlar_image() {
    return paint("ashlar", 512, 512, ashlar_colour);
}

Image stone_image() {
    return paint("stone", 128, 128, stone_colour);
}

Image plaster_image() {
    return paint("plaster", 256, 256, plaster_colour);
}

Image brick_image() {
    return paint("brick", 512, 512, brick_colour);
}

Image roof_image() {
    return paint("roof tiles", 512, 512, roof_colour);
}

Image bark_image() {
    return paint("bark", 128, 128, bark_colour);
}

Image leaf_image() {
    return paint("leaves", 256, 256, leaf_colour);
}

Image grass_image() {
    return paint("grass", 256, 256, grass_colour);
}

} // namespace content::generator

#include "content/generator/opening_paint.h"

#include "content/generator/paint.h"

#include <algorithm>

namespace content::generator {
namespace {

// One window in its own square, point in [0, 1]^2.
glm::vec3 window_colour(const glm::vec2& point, int variant) {
    constexpr float texel = 1.0f / 250.0f;
    const float sky = glm::smoothstep(0.1f, 1.0f, point.y + 0.15f * std::sin(5.0f * point.x));
    glm::vec3 colour = glm::mix(encoded(0x20262b), encoded(0x5f7383), sky * 0.8f);
    const float curtain = 0.5f - std::abs(point.x - 0.5f);
    const float fold = 0.85f + 0.15f * std::sin(point.x * 90.0f);
    if (variant == 1 || variant == 3) {
        const float hem = curtain - 0.10f - 0.10f * point.y * point.y;
        colour = glm::mix(colour, encoded(variant == 1 ? 0xd9cfbb : 0xb9a081) * fold, 0.8f * coverage(hem, 0.02f));
    }
    if (variant == 2) {
        colour = glm::mix(colour, encoded(0xcfc6b4) * (0.93f + 0.07f * std::sin(point.y * 140.0f)),
                          0.85f * coverage(0.55f - point.y, texel));
    }
    const float frame = -box_distance(point, glm::vec2(0.5f), glm::vec2(0.5f)) - 0.055f;
    const float mullion = std::abs(point.x - 0.5f) - 0.03f;
    const float bars = std::min(std::abs(point.y - 0.68f), variant == 0 ? std::abs(point.y - 0.34f) : 1.0f) - 0.018f;
    const float wood = std::min({frame, mullion, bars});
    colour *= 0.72f + 0.28f * glm::smoothstep(0.0f, 0.03f, wood); // the frame's own shadow on the glass
    return glm::mix(colour, encoded(0xe8e2d4), coverage(wood, texel * 1.5f));
}

glm::vec3 door_colour(const glm::vec2& point, int variant) {
    constexpr float texel = 1.0f / 250.0f;
    const glm::vec3 wood =
        encoded(variant == 0 ? 0x39564a : 0x6d3a2a) * (0.88f + 0.16f * clouds(point, {16, 3}, 3, 109));
    glm::vec3 colour = wood;
    const glm::vec2 folded{std::abs(point.x - 0.5f), point.y};
    for (const glm::vec2& panel : {glm::vec2(0.14f, 0.45f), glm::vec2(0.26f, 0.0f)}) {
        const float d =
            box_distance(folded, {0.24f, panel.x + panel.y * 0.66f}, {0.15f, panel.y == 0.0f ? 0.16f : 0.19f}, 0.02f);
        colour = glm::mix(colour, wood * 0.55f, coverage(std::abs(d) - 0.012f, texel * 2.0f));
    }
    colour =
        glm::mix(colour, encoded(0x2c3338), coverage(box_distance(point, {0.5f, 0.86f}, {0.38f, 0.07f}, 0.02f), texel));
    colour = glm::mix(colour, wood * 0.4f,
                      coverage(std::abs(point.x - 0.5f) - 0.008f, texel) * (point.y < 0.76f ? 1.0f : 0.0f));
    colour = glm::mix(colour, encoded(0xd9b25f), coverage(disk_distance(point, {0.56f, 0.40f}, 0.022f), texel));
    const float frame = std::min({point.x, 1.0f - point.x, 1.0f - point.y}) - 0.045f;
    return glm::mix(colour, encoded(0xe3dccb), coverage(frame, texel));
}

// Left half: windows in a 2 x 2 pattern; right half: two doors.
glm::vec3 opening_colour(const glm::vec2& point) {
    if (point.x < 0.5f) {
        const glm::vec2 p = point * glm::vec2(4.0f, 2.0f);
        const glm::ivec2 place(glm::floor(p));
        return window_colour(glm::fract(p), place.x + 2 * place.y);
    }
    const float x = (point.x - 0.5f) * 4.0f;
    return door_colour({glm::fract(x), point.y}, static_cast<int>(x));
}

// Two shop fronts, one above the other, each four times as wide as high.
glm::vec3 shop_colour(const glm::vec2& point) {
    const int variant = point.y < 0.5f ? 0 : 1;
    const glm::vec2 p{point.x * 4.0f, glm::fract(point.y * 2.0f)};
    constexpr float texel = 4.0f / 1024.0f;
    const glm::vec3 frame = encoded(variant == 0 ? 0x28463f : 0x7a2f2c);
    glm::vec3 colour = frame;
    const auto pane = [&](float centre, float half_width) {
        const float d = box_distance(p, {centre, 0.44f}, {half_width, 0.27f}, 0.01f);
        const float display = clouds(point, {40, 10}, 3, 113);
        glm::vec3 glass = glm::mix(encoded(0x1e2326), encoded(0x6f7f88), glm::smoothstep(0.3f, 0.75f, p.y) * 0.7f);
        const glm::vec3 goods = glm::mix(encoded(0xb5894f), encoded(0x7f4a38), noise(point, {60, 16}, 127));
        glass = glm::mix(glass, goods, 0.75f * coverage(p.y - 0.19f - 0.22f * display, 0.03f));
        colour = glm::mix(colour, encoded(0xe0cf9f), 0.8f * coverage(d - 0.02f, texel));
        colour = glm::mix(colour, glass, coverage(d, texel));
    };
    pane(0.78f, 0.62f);
    pane(3.22f, 0.62f);
    pane(2.0f, 0.30f);
    const float sign = box_distance(p, {2.0f, 0.86f}, {1.85f, 0.09f}, 0.02f);
    colour = glm::mix(colour, frame * 0.72f, coverage(sign, texel));
    // Lettering as a row of gilded strokes: too far away to be read.
    const float letters = glm::fract(p.x * 6.0f);
    const float stroke =
        std::abs(letters - 0.5f) - 0.14f - 0.16f * random_at(static_cast<int>(p.x * 6.0f), variant, 131);
    const bool in_word = std::abs(p.x - 2.0f) < 1.2f && std::abs(p.y - 0.86f) < 0.05f;
    colour = glm::mix(colour, encoded(0xe6c878), in_word ? 0.9f * coverage(stroke, texel * 6.0f) : 0.0f);
    return colour;
}

glm::vec3 rose_colour(const glm::vec2& point) {
    const glm::vec2 p = point * 2.0f - 1.0f;
    const float radius = glm::length(p);
    const float angle = std::atan2(p.y, p.x);
    const float petal = std::abs(std::sin(angle * 6.0f)) * radius;
    const glm::vec3 glass =
        glm::mix(encoded(0x2f4d78), encoded(0x8c3b46), 0.5f + 0.5f * std::sin(angle * 12.0f + radius * 9.0f));
    const float tracery = std::min({petal - 0.07f, std::abs(radius - 0.36f) - 0.04f, 0.86f - radius});
    const glm::vec3 colour = glm::mix(glass, encoded(0xcdbf9f), coverage(tracery, 0.015f));
    return glm::mix(colour, encoded(0x9a8c70), coverage(std::abs(radius - 0.92f) - 0.07f, 0.015f));
}

glm::vec3 clock_colour(const glm::vec2& point) {
    const glm::vec2 p = point * 2.0f - 1.0f;
    const float radius = glm::length(p);
    glm::vec3 colour = encoded(0x23324a);
    colour = glm::mix(colour, encoded(0xe0bf6a), coverage(std::abs(radius - 0.86f) - 0.05f, 0.015f));
    const float hour = std::atan2(p.x, p.y) / 6.2831853f * 12.0f;
    const float tick = std::abs(glm::fract(hour + 0.5f) - 0.5f) * radius * 0.52f - 0.018f;
    colour =
        glm::mix(colour, encoded(0xe0bf6a), coverage(tick, 0.015f) * (radius > 0.6f && radius < 0.78f ? 1.0f : 0.0f));
    const auto hand = [&](float turns, float length) {
        const glm::vec2 d{std::sin(6.2831853f * turns), std::cos(6.2831853f * turns)};
        const float along = std::clamp(glm::dot(p, d), -0.1f, length);
        colour = glm::mix(colour, encoded(0xf0dc9a), coverage(glm::length(p - along * d) - 0.03f, 0.015f));
    };
    hand(10.17f / 12.0f, 0.42f);
    hand(10.0f / 60.0f, 0.64f);
    return colour;
}

// A pointed opening: portal with two wings, or a window with bars. p.x in [-1, 1], p.y in [0, 1].
glm::vec3 pointed_colour(const glm::vec2& point, bool portal) {
    const glm::vec2 p{point.x * 2.0f - 1.0f, point.y};
    const float spring = 0.55f;
    const float lift = std::max(0.0f, (p.y - spring) / (1.0f - spring));
    const float half = 0.78f * std::sqrt(std::max(0.0f, 1.0f - lift * lift));
    const float d = std::max(std::abs(p.x) - half, p.y - 0.95f);
    const glm::vec3 stone = encoded(0xc4b594) * (0.92f + 0.1f * clouds(point, {8, 8}, 3, 137));
    const glm::vec3 dark = encoded(0x8f8167);
    glm::vec3 colour = glm::mix(stone, dark, 0.8f * coverage(std::abs(d - 0.10f) - 0.03f, 0.015f));
    glm::vec3 inside = encoded(portal ? 0x4e2f20 : 0x2a3441);
    const float bars = portal ? std::abs(p.x) - 0.02f
                              : std::min(std::abs(p.x), std::abs(glm::fract(p.y * 6.0f) - 0.5f) * 0.4f) - 0.03f;
    inside = glm::mix(inside, encoded(portal ? 0x241610 : 0xa89a7c), coverage(bars, 0.015f));
    if (portal) {
        inside *= 0.8f + 0.4f * noise(point, {16, 2}, 139);
    }
    return glm::mix(colour, inside, coverage(d, 0.015f));
}

// Four square pictures side by side: rose window, clock, portal, lancet window.
glm::vec3 church_colour(const glm::vec2& point) {
    const float x = point.x * 4.0f;
    const glm::vec2 p{glm::fract(x), point.y};
    switch (static_cast<int>(x)) {
    case 0:
        return rose_colour(p);
    case 1:
        return clock_colour(p);
    case 2:
        return pointed_colour(p, true);
    default:
        return pointed_colour(p, false);
    }
}

// Areas keep a texel's distance from their neighbours, lest filtering mixes them.
TextureArea inset(const glm::vec2& low, const glm::vec2& high, const glm::vec2& texels) {
    const glm::vec2 margin = 1.0f / texels;
    return {low + margin, high - margin};
}

TextureArea church_area(int index) {
    const float x = 0.25f * static_cast<float>(index);
    return inset({x, 0.0f}, {x + 0.25f, 1.0f}, {1024.0f, 256.0f});
}

} // namespace

Image opening_image() {
    return paint("windows and doors", 1024, 512, opening_colour);
}

Image shop_image() {
    return paint("shop fronts", 1024, 512, shop_colour);
}

Image church_image() {
    return paint("church openings", 1024, 256, church_colour);
}

TextureArea window_area(int variant) {
    const glm::vec2 low = glm::vec2(0.25f, 0.5f) * glm::vec2(variant % 2, variant / 2);
    return inset(low, low + glm::vec2(0.25f, 0.5f), {1024.0f, 512.0f});
}

TextureArea door_area(int variant) {
    const float x = 0.5f + 0.25f * static_cast<float>(variant);
    return inset({x, 0.0f}, {x + 0.25f, 1.0f}, {1024.0f, 512.0f});
}

TextureArea shop_area(int variant) {
    const float y = 0.5f * static_cast<float>(variant);
    return inset({0.0f, y}, {1.0f, y + 0.5f}, {1024.0f, 512.0f});
}

TextureArea rose_window_area() {
    return church_area(0);
}

TextureArea clock_area() {
    return church_area(1);
}

TextureArea portal_area() {
    return church_area(2);
}

TextureArea lancet_area() {
    return church_area(3);
}

} // namespace content::generator

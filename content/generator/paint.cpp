#include "content/generator/paint.h"

namespace content::generator {
namespace {

std::uint32_t mixed(std::uint32_t value) {
    value ^= value >> 16U;
    value *= 0x7feb352dU;
    value ^= value >> 15U;
    value *= 0x846ca68bU;
    return value ^ (value >> 16U);
}

float linear_from_encoded(float encoded_value) {
    return encoded_value <= 0.04045f ? encoded_value / 12.92f : std::pow((encoded_value + 0.055f) / 1.055f, 2.4f);
}

} // namespace

glm::vec3 linear(std::uint32_t hex) {
    const glm::vec3 colour = encoded(hex);
    return {linear_from_encoded(colour.r), linear_from_encoded(colour.g), linear_from_encoded(colour.b)};
}

float random_at(int x, int y, std::uint32_t seed) {
    const std::uint32_t hash = mixed(static_cast<std::uint32_t>(x) * 0x9e3779b1U +
                                     static_cast<std::uint32_t>(y) * 0x85ebca77U + seed * 0xc2b2ae3dU);
    return static_cast<float>(hash >> 8U) / 16777216.0f;
}

float noise(const glm::vec2& point, const glm::ivec2& cells, std::uint32_t seed) {
    const glm::vec2 scaled = point * glm::vec2(cells);
    const glm::vec2 corner = glm::floor(scaled);
    const glm::vec2 inside = scaled - corner;
    const glm::vec2 weight = inside * inside * (3.0f - 2.0f * inside);
    const glm::ivec2 low = glm::ivec2(corner) % cells;
    const glm::ivec2 high{low.x + 1 == cells.x ? 0 : low.x + 1, low.y + 1 == cells.y ? 0 : low.y + 1};
    const float bottom = glm::mix(random_at(low.x, low.y, seed), random_at(high.x, low.y, seed), weight.x);
    const float top = glm::mix(random_at(low.x, high.y, seed), random_at(high.x, high.y, seed), weight.x);
    return glm::mix(bottom, top, weight.y);
}

float clouds(const glm::vec2& point, const glm::ivec2& cells, int octaves, std::uint32_t seed) {
    float sum = 0.0f;
    float total = 0.0f;
    float strength = 1.0f;
    glm::ivec2 finer = cells;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += strength * noise(point, finer, seed + static_cast<std::uint32_t>(octave));
        total += strength;
        strength *= 0.5f;
        finer *= 2;
    }
    return sum / total;
}

} // namespace content::generator

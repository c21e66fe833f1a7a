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

int wrapped(int value, int period) {
    return ((value % period) + period) % period;
}

} // namespace

glm::vec3 linear(std::uint32_t hex) {
    const glm::vec3 colour = encoded(hex);
    return {linear_from_encoded(colour.r), linear_from_encoded(colour.g), linear_from_encoded(colour.b)};
}

float random_at(int x, int y, std::uint32_t seed) {
    const std::uint32_t hash =
        mixed(static_cast<std::uint32_t>(x) + mixed(static_cast<std::uint32_t>(y) + mixed(seed)));
    return static_cast<float>(hash >> 8U) / 16777216.0f;
}

float noise(const glm::vec2& point, const glm::ivec2& cells, std::uint32_t seed) {
    const glm::vec2 scaled = point * glm::vec2(cells);
    const glm::vec2 corner = glm::floor(scaled);
    const glm::vec2 inside = scaled - corner;
    const glm::vec2 weight = inside * inside * (3.0f - 2.0f * inside);
    const auto at = [&](int dx, int dy) {
        return random_at(wrapped(static_cast<int>(corner.x) + dx, cells.x),
                         wrapped(static_cast<int>(corner.y) + dy, cells.y), seed);
    };
    return glm::mix(glm::mix(at(0, 0), at(1, 0), weight.x), glm::mix(at(0, 1), at(1, 1), weight.x), weight.y);
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

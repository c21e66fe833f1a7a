#include "render/raycast/packet_display.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <tbb/parallel_for.h>
#include <utility>

namespace render {
namespace display_shader {
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::floatBitsToUint;
using glm::greaterThan;
using glm::mat3;
using glm::max;
using glm::min;
using glm::mix;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::vec2;
using glm::vec3;
inline vec3 floor(const vec3& x) {
    return {static_cast<float>(floor_of_lane(x.x)), static_cast<float>(floor_of_lane(x.y)),
            static_cast<float>(floor_of_lane(x.z))};
}
inline float fract(float x) {
    return x - static_cast<float>(floor_of_lane(x));
}
// Calls would keep loops of these from becoming vectors.
struct Gamut;
struct HueLine;
struct SaturationSearch;
[[gnu::always_inline]] inline HueLine hue_line(vec3 rgb, Gamut gamut);
[[gnu::always_inline]] inline float room_in_gamut(HueLine line, float saturation, float most, Gamut gamut);
[[gnu::always_inline]] inline SaturationSearch begin_search(HueLine line, float most, Gamut gamut);
[[gnu::always_inline]] inline SaturationSearch halved(SaturationSearch search, float part, HueLine line, float most,
                                                      Gamut gamut);
[[gnu::always_inline]] inline float found_saturation(SaturationSearch search);
[[gnu::always_inline]] inline vec3 fitting_colour(HueLine line, float saturation, float most, Gamut gamut);
#include "render/shaders/shared/display.glsl"
} // namespace display_shader
namespace {

glm::vec3 lane_of(const Lanes3& light, int lane) {
    return {light.x[lane], light.y[lane], light.z[lane]};
}

void set_lane(Lanes3& light, int lane, const glm::vec3& value) {
    light.x[lane] = value.x;
    light.y[lane] = value.y;
    light.z[lane] = value.z;
}

/// Exposes light; returns whether none of it is outside the gamut.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] bool expose(const Lanes3& light, float exposure, float most, Lanes3& exposed) {
    int outside = 0;
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 colour = exposure * lane_of(light, i);
        outside |= display_shader::outside_gamut(colour, most) ? 1 : 0;
        set_lane(exposed, i, colour);
    }
    return outside == 0;
}

/// display_shader::HueLine of each lane.
struct HueLines {
    Lanes grey;
    Lanes3 linear;
    Lanes3 quadratic;
    Lanes3 cubic;
    Lanes luminance;

    void set(int i, const display_shader::HueLine& line) {
        grey[i] = line.grey;
        set_lane(linear, i, line.linear);
        set_lane(quadratic, i, line.quadratic);
        set_lane(cubic, i, line.cubic);
        luminance[i] = line.luminance;
    }
    display_shader::HueLine at(int i) const {
        return {grey[i], lane_of(linear, i), lane_of(quadratic, i), lane_of(cubic, i), luminance[i]};
    }
};

/// display_shader::SaturationSearch of each lane.
struct SaturationSearches {
    Lanes fitting;
    Lanes room_fitting;
    Lanes room_above;

    void set(int i, const display_shader::SaturationSearch& search) {
        fitting[i] = search.fitting;
        room_fitting[i] = search.room_fitting;
        room_above[i] = search.room_above;
    }
    display_shader::SaturationSearch at(int i) const { return {fitting[i], room_fitting[i], room_above[i]}; }
};

/// display_shader::within_gamut for lanes of which some are outside.
[[gnu::always_inline]] inline void bring_within_gamut(Lanes3& light, float most) {
    const display_shader::Gamut gamut = display_shader::srgb_gamut();
    HueLines lines;
    SaturationSearches searches;
    for (int i = 0; i < lane_count; ++i) {
        const display_shader::HueLine line = display_shader::hue_line(lane_of(light, i), gamut);
        lines.set(i, line);
        searches.set(i, display_shader::begin_search(line, most, gamut));
    }
    for (float part = display_shader::first_part; part >= display_shader::last_part; part *= 0.5f) {
        for (int i = 0; i < lane_count; ++i) {
            searches.set(i, display_shader::halved(searches.at(i), part, lines.at(i), most, gamut));
        }
    }
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 colour = lane_of(light, i);
        const glm::vec3 found =
            display_shader::fitting_colour(lines.at(i), display_shader::found_saturation(searches.at(i)), most, gamut);
        const bool outside = display_shader::outside_gamut(colour, most);
        set_lane(light, i, {outside ? found.x : colour.x, outside ? found.y : colour.y, outside ? found.z : colour.z});
    }
}

RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void bring_within_gamut_of_any_brightness(Lanes3& light) {
    bring_within_gamut(light, display_shader::unlimited);
}

RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void bring_within_limited_gamut(Lanes3& light, float most) {
    bring_within_gamut(light, most);
}

/// Colours inside the gamut to encoded ones.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void encode_filmic(Lanes3& light, float most, float brightest) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 clamped = glm::clamp(lane_of(light, i), 0.0f, most);
        set_lane(light, i, display_shader::encoded_inside(clamped, true, brightest));
    }
}

RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void encode_linear(Lanes3& light, float most, float brightest) {
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 clamped = glm::clamp(lane_of(light, i), 0.0f, most);
        set_lane(light, i, display_shader::encoded_inside(clamped, false, brightest));
    }
}

/// Encoded colours to bytes; `left` and `bottom`: the packet's place in the picture, pixels.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void quantise(const Lanes3& encoded, bool dither, float left, float bottom,
                                                      LaneIndices& rgba) {
    // In three loops, each of which becomes vectors.
    Lanes threshold;
    for (int i = 0; i < lane_count; ++i) {
        const float fraction =
            display_shader::dither_threshold({left + static_cast<float>(i & 3), bottom + static_cast<float>(i >> 2)});
        threshold[i] = dither ? fraction : 0.5f;
    }
    Lanes3 steps;
    for (int i = 0; i < lane_count; ++i) {
        set_lane(steps, i, display_shader::display_steps(lane_of(encoded, i), threshold[i]));
    }
    const auto byte = [](float step) { return static_cast<std::uint32_t>(static_cast<int>(step)); };
    for (int i = 0; i < lane_count; ++i) {
        rgba[i] = byte(steps.x[i]) | byte(steps.y[i]) << 8u | byte(steps.z[i]) << 16u | 0xff000000u;
    }
}

/// Mean luminances, not below 0, of a packet's four squares of 2 x 2 pixels.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void spot_luminances(const Lanes3& light, std::array<float, 4>& spots) {
    Lanes luminances;
    for (int i = 0; i < lane_count; ++i) {
        luminances[i] = display_shader::luminance(lane_of(light, i));
    }
    for (int i = 0; i < 4; ++i) {
        const int first = 8 * (i / 2) + 2 * (i % 2);
        const float sum = (luminances[first] + luminances[first + 1]) + (luminances[first + 4] + luminances[first + 5]);
        spots[static_cast<std::size_t>(i)] = sum > 0.0f ? 0.25f * sum : 0.0f;
    }
}

} // namespace

MeteredLight metered(const LightPackets& packets, double pre_exposure) {
    // A square is two by two packets; of a picture smaller than that, what there is.
    const int columns = std::max(packets.width / (2 * packet_side), 1);
    const int rows = std::max(packets.height / (2 * packet_side), 1);
    const std::size_t squares = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    MeteredLight result{std::vector<float>(squares), std::vector<float>(squares)};
    tbb::parallel_for(0, rows, [&](int row) {
        for (int column = 0; column < columns; ++column) {
            float sum = 0.0f;
            float brightest = 0.0f;
            for (const auto& [right, up] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
                const int packet_column = std::min(2 * column + right, packets.columns() - 1);
                const int packet_row = std::min(2 * row + up, packets.rows() - 1);
                std::array<float, 4> spots;
                spot_luminances(packets.light[packets.packet(packet_side * packet_column, packet_side * packet_row)],
                                spots);
                for (const float spot : spots) {
                    sum += spot;
                    brightest = std::max(brightest, spot);
                }
            }
            const std::size_t square =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
            result.mean[square] = static_cast<float>(static_cast<double>(sum / 16.0f) / pre_exposure);
            result.brightest[square] = static_cast<float>(static_cast<double>(brightest) / pre_exposure);
        }
    });
    return result;
}

void show_packets(const LightPackets& packets, const DisplaySettings& settings, std::span<std::uint32_t> rgba) {
    static_assert(std::endian::native == std::endian::little); // or red would not be the first byte
    const float most = display_shader::most_before_curve(!settings.linear_curve, settings.brightest);
    const auto& encode = settings.linear_curve ? encode_linear : encode_filmic;
    tbb::parallel_for(0, packets.rows(), [&](int row) {
        const int bottom = packet_side * row;
        const int rows = std::min(packet_side, packets.height - bottom);
        for (int left = 0; left < packets.width; left += packet_side) {
            Lanes3 light;
            if (!expose(packets.light[packets.packet(left, bottom)], settings.exposure, most, light)) {
                if (settings.linear_curve) {
                    bring_within_limited_gamut(light, most);
                } else {
                    bring_within_gamut_of_any_brightness(light);
                }
            }
            LaneIndices shown;
            encode(light, most, settings.brightest);
            quantise(light, settings.dither, static_cast<float>(left), static_cast<float>(bottom), shown);
            const int columns = std::min(packet_side, packets.width - left);
            for (int y = 0; y < rows; ++y) {
                const std::size_t first =
                    static_cast<std::size_t>(bottom + y) * static_cast<std::size_t>(packets.width) +
                    static_cast<std::size_t>(left);
                std::copy_n(&shown.values.at(static_cast<std::size_t>(packet_side * y)), columns, &rgba[first]);
            }
        }
    });
}

} // namespace render

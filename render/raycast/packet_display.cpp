#include "render/raycast/packet_display.h"

#include "render/colour/linear_filter.h"
#include "render/raycast/lane_vectors.h"

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

/// What decides whether a fraction of a step becomes a whole one, for rows of 2^log2_columns pixels, the first of which
/// is at (left, bottom) in the picture.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void dither_thresholds(int log2_columns, int left, int bottom,
                                                               Lanes& thresholds) {
    const int column_bits = (1 << log2_columns) - 1;
    for (int i = 0; i < lane_count; ++i) {
        thresholds[i] = display_shader::dither_threshold(
            {static_cast<float>(left + (i & column_bits)), static_cast<float>(bottom + (i >> log2_columns))});
    }
}

/// Encoded colours to bytes.
RAPIDITY_VECTOR_CLONES [[gnu::flatten]] void quantise(const Lanes3& encoded, const Lanes& thresholds, bool blue_first,
                                                      LaneIndices& bytes) {
    Lanes3 steps;
    for (int i = 0; i < lane_count; ++i) {
        set_lane(steps, i, display_shader::display_steps(lane_of(encoded, i), thresholds[i]));
    }
    const auto byte = [](float step) { return static_cast<std::uint32_t>(static_cast<int>(step)); };
    const Lanes& first = blue_first ? steps.z : steps.x;
    const Lanes& third = blue_first ? steps.x : steps.z;
    for (int i = 0; i < lane_count; ++i) {
        bytes[i] = byte(first[i]) | byte(steps.y[i]) << 8u | byte(third[i]) << 16u | 0xff000000u;
    }
}

/// Encodes colours to the bytes of 16 pixels, in rows of 2^log2_columns.
void to_bytes(const Lanes3& encoded, const DisplaySettings& settings, const ByteLayout& layout, int log2_columns,
              const glm::ivec2& corner, LaneIndices& bytes) {
    Lanes thresholds;
    if (settings.dither) {
        dither_thresholds(log2_columns, corner.x, corner.y, thresholds);
    } else {
        thresholds.values.fill(0.5f);
    }
    quantise(encoded, thresholds, layout.blue_first, bytes);
}

/// Calls put(left, bottom, encoded colours) for every packet, rows of them on all processors.
template <class Put>
void encode(const LightPackets& packets, const DisplaySettings& settings, const Put& put) {
    const float most = display_shader::most_before_curve(!settings.linear_curve, settings.brightest);
    tbb::parallel_for(0, packets.rows(), [&](int row) {
        const int bottom = packet_side * row;
        for (int left = 0; left < packets.width; left += packet_side) {
            Lanes3 light;
            const bool inside = expose(packets.light[packets.packet(left, bottom)], settings.exposure, most, light);
            if (settings.linear_curve) {
                if (!inside) {
                    bring_within_limited_gamut(light, most);
                }
                encode_linear(light, most, settings.brightest);
            } else {
                if (!inside) {
                    bring_within_gamut_of_any_brightness(light);
                }
                encode_filmic(light, most, settings.brightest);
            }
            put(left, bottom, light);
        }
    });
}

/// Where a pixel, from the lower left corner, lies in a picture of that size.
std::size_t place_of(int x, int y, const glm::ivec2& size, bool from_top) {
    return static_cast<std::size_t>(from_top ? size.y - 1 - y : y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(x);
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

std::span<const std::uint32_t> PacketDisplay::show(const LightPackets& packets, const DisplaySettings& settings,
                                                   const glm::ivec2& size, const ByteLayout& layout) {
    static_assert(std::endian::native == std::endian::little); // or the first would not be the lowest byte
    const glm::ivec2 from(packets.width, packets.height);
    bytes_.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const auto inside = [&](int left, int bottom) {
        return glm::min(glm::ivec2(packet_side), from - glm::ivec2(left, bottom));
    };
    if (size == from) {
        encode(packets, settings, [&](int left, int bottom, const Lanes3& encoded) {
            LaneIndices bytes;
            to_bytes(encoded, settings, layout, 2, {left, bottom}, bytes);
            const glm::ivec2 shown = inside(left, bottom);
            for (int y = 0; y < shown.y; ++y) {
                std::copy_n(bytes.values.begin() + packet_side * y, shown.x,
                            &bytes_[place_of(left, bottom + y, size, layout.from_top)]);
            }
        });
        return bytes_;
    }
    encoded_.resize(static_cast<std::size_t>(from.x) * static_cast<std::size_t>(from.y));
    encode(packets, settings, [&](int left, int bottom, const Lanes3& encoded) {
        const glm::ivec2 shown = inside(left, bottom);
        for (int y = 0; y < shown.y; ++y) {
            Four* const row = &encoded_[place_of(left, bottom + y, from, false)];
            for (int x = 0; x < shown.x; ++x) {
                const int lane = packet_side * y + x;
                row[x] = Four{encoded.x[lane], encoded.y[lane], encoded.z[lane], 0.0f};
            }
        }
    });
    show_scaled(from, settings, size, layout);
    return bytes_;
}

void PacketDisplay::show_scaled(const glm::ivec2& from, const DisplaySettings& settings, const glm::ivec2& size,
                                const ByteLayout& layout) {
    const glm::vec2 scale = glm::vec2(from) / glm::vec2(size);
    std::vector<Between> columns;
    columns.reserve(static_cast<std::size_t>(size.x));
    for (int x = 0; x < size.x; ++x) {
        columns.emplace_back((static_cast<float>(x) + 0.5f) * scale.x, from.x);
    }
    tbb::parallel_for(0, size.y, [&](int y) {
        const Between rows((static_cast<float>(y) + 0.5f) * scale.y, from.y);
        const Four* const below = &encoded_[place_of(0, rows.first, from, false)];
        const Four* const above = &encoded_[place_of(0, rows.second, from, false)];
        std::vector<Four> between(static_cast<std::size_t>(from.x));
        for (std::size_t x = 0; x < between.size(); ++x) {
            between[x] = below[x] + rows.share * (above[x] - below[x]);
        }
        for (int left = 0; left < size.x; left += lane_count) {
            const int shown = std::min(lane_count, size.x - left);
            Lanes3 colours;
            for (int i = 0; i < shown; ++i) {
                const Between& column = columns[static_cast<std::size_t>(left) + static_cast<std::size_t>(i)];
                const Four first = between[static_cast<std::size_t>(column.first)];
                const Four colour = first + column.share * (between[static_cast<std::size_t>(column.second)] - first);
                set_lane(colours, i, {colour[0], colour[1], colour[2]});
            }
            LaneIndices bytes;
            to_bytes(colours, settings, layout, 4, {left, y}, bytes);
            std::copy_n(bytes.values.begin(), shown, &bytes_[place_of(left, y, size, layout.from_top)]);
        }
    });
}

} // namespace render

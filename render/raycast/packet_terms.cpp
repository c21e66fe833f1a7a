#include "render/raycast/packet_terms.h"

#include "render/raycast/lane_vectors.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>

namespace render {
namespace reflectance_shader {
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::max;
using glm::min;
using glm::normalize;
using glm::smoothstep;
using glm::sqrt;
using glm::vec2;
using glm::vec3;
inline float log2(float x) {
    return log2_of_lane(x);
}
#include "render/shaders/shared/colour.glsl"
#include "render/shaders/shared/reflectance.glsl"
} // namespace reflectance_shader
namespace {

constexpr int samples = FrameColourTable::samples;

/// Light seen of a term at a place of the table.
inline glm::vec3 term_at(const FrameColourTable& table, const TermPlace& term, float place) {
    const int whole = static_cast<int>(place) < samples - 2 ? static_cast<int>(place) : samples - 2;
    const float share = place - static_cast<float>(whole);
    const float* const texels = table.texels.data();
    const auto value = [&](int layer, std::size_t component) {
        const float* const at = texels + table.texel(layer, whole) + component;
        return at[0] + share * (at[4] - at[0]);
    };
    if (term.in_alphas) {
        return {value(term.layer, 3), value(term.layer + 1, 3), value(term.layer + 2, 3)};
    }
    return {value(term.layer, 0), value(term.layer, 1), value(term.layer, 2)};
}

RAPIDITY_VECTOR_CLONES
void add_joined(const glm::vec3& low, const glm::vec3& rise, const Lanes& share, const Lanes& weight, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        light.x[i] += weight[i] * (low.x + share[i] * rise.x);
        light.y[i] += weight[i] * (low.y + share[i] * rise.y);
        light.z[i] += weight[i] * (low.z + share[i] * rise.z);
    }
}

} // namespace

RAPIDITY_VECTOR_CLONES
PacketPlaces places_of(const FrameColourTable& table, const Lanes& wavelength_ratio) {
    const glm::vec2 scale_and_offset(table.coordinate_scale, table.coordinate_offset);
    PacketPlaces places;
    for (int i = 0; i < lane_count; ++i) {
        const float place =
            samples * reflectance_shader::colour_coordinate(wavelength_ratio[i], scale_and_offset) - 0.5f;
        places.place[i] = place > 0.0f ? (place < samples - 1.0f ? place : samples - 1.0f) : 0.0f;
    }
    places.lowest = *std::min_element(places.place.values.begin(), places.place.values.end());
    places.highest = *std::max_element(places.place.values.begin(), places.place.values.end());
    places.narrow = places.highest - places.lowest < 2.0f;
    const float scale = places.highest > places.lowest ? 1.0f / (places.highest - places.lowest) : 0.0f;
    for (int i = 0; i < lane_count; ++i) {
        places.share[i] = scale * (places.place[i] - places.lowest);
    }
    return places;
}

TermPlace place_of_term(int first_layer, int term) {
    if (term == 3) {
        return {first_layer, true};
    }
    return {first_layer + (term < 3 ? term : term - 1)};
}

void add_term(const PacketColours& colours, const TermPlace& term, const Lanes& weight, Lanes3& light) {
    const PacketPlaces& places = colours.places;
    if (places.narrow) {
        const glm::vec3 low = term_at(colours.table, term, places.lowest);
        const glm::vec3 high = term_at(colours.table, term, places.highest);
        add_joined(low, high - low, places.share, weight, light);
        return;
    }
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 seen = weight[i] * term_at(colours.table, term, places.place[i]);
        light.x[i] += seen.x;
        light.y[i] += seen.y;
        light.z[i] += seen.z;
    }
}

void add_term(const PacketColours& colours, int first_layer, int term, const Lanes& weight, Lanes3& light) {
    add_term(colours, place_of_term(first_layer, term), weight, light);
}

namespace {

RAPIDITY_VECTOR_CLONES
void add_scaled(float scale, const Lanes3& rgb, Lanes3& light) {
    for (int i = 0; i < lane_count; ++i) {
        light.x[i] += scale * rgb.x[i];
        light.y[i] += scale * rgb.y[i];
        light.z[i] += scale * rgb.z[i];
    }
}

/// A group's three primaries, weighted by linear RGB.
void add_primaries(const PacketColours& colours, int first_layer, const Lanes3& rgb, Lanes3& light) {
    add_term(colours, first_layer, 0, rgb.x, light);
    add_term(colours, first_layer, 1, rgb.y, light);
    add_term(colours, first_layer, 2, rgb.z, light);
}

} // namespace

void add_radiance(const PacketColours& colours, int first_layer, const Lanes3& rgb, Lanes3& light) {
    if (colours.table.plain_gain > 0.0f) {
        add_scaled(colours.table.plain_gain, rgb, light);
    } else {
        add_primaries(colours, first_layer, rgb, light);
    }
}

RAPIDITY_VECTOR_CLONES
void lit_colours(const Lanes3& reflectance, const Lanes3& received, const Lanes& share, Lanes3& rgb) {
    for (int i = 0; i < lane_count; ++i) {
        // Lanes that hit nothing may hold anything.
        const bool counts = share[i] > 0.0f;
        rgb.x[i] = counts ? reflectance.x[i] * received.x[i] : 0.0f;
        rgb.y[i] = counts ? reflectance.y[i] * received.y[i] : 0.0f;
        rgb.z[i] = counts ? reflectance.z[i] * received.z[i] : 0.0f;
    }
}

RAPIDITY_VECTOR_CLONES
void light_surfaces(const Lanes3& reflectance, const Lanes3& received, const Lanes& share, LitLanes& lit) {
    lit_colours(reflectance, received, share, lit.rgb);
    for (int i = 0; i < lane_count; ++i) {
        const float luminance = share[i] > 0.0f ? reflectance_shader::luminance_of(lane_of(received, i)) : 0.0f;
        set_lane(lit.features, i, luminance * reflectance_shader::reflectance_features(lane_of(reflectance, i)));
        lit.luminance[i] = luminance;
    }
}

void add_hues(const PacketColours& colours, const HueWheel& wheel, int layer, const Lanes3& rgb, Lanes3& light) {
    Lanes white;
    for (int i = 0; i < lane_count; ++i) {
        const glm::vec3 hue = reflectance_shader::hue_of(lane_of(rgb, i));
        white[i] = hue.x;
        if (hue.y <= 0.0f) {
            continue;
        }
        const HueWheel::Beside beside = wheel.beside(static_cast<double>(hue.z));
        const int first = layer + 1 + static_cast<int>(beside.hue);
        const int next = beside.hue + 1 == wheel.hues() ? layer + 1 : first + 1;
        const glm::vec3 a = term_at(colours.table, {first}, colours.places.place[i]);
        const glm::vec3 b = term_at(colours.table, {next}, colours.places.place[i]);
        const glm::vec3 seen = hue.y * (a + static_cast<float>(beside.share) * (b - a));
        set_lane(light, i, lane_of(light, i) + seen);
    }
    add_term(colours, {layer}, white, light);
}

RAPIDITY_VECTOR_CLONES
void luminance_of_lanes(const Lanes3& rgb, Lanes& luminance) {
    for (int i = 0; i < lane_count; ++i) {
        luminance[i] = reflectance_shader::luminance_of(lane_of(rgb, i));
    }
}

void add_lit(const PacketColours& colours, content::ReflectanceRule rule, int layer, const LitLanes& lit,
             const Lanes3& reflectance, Lanes3& light) {
    if (rule == content::ReflectanceRule::own) {
        Lanes weight;
        luminance_of_lanes(reflectance, weight);
        for (int i = 0; i < lane_count; ++i) {
            weight[i] *= lit.luminance[i];
        }
        add_term(colours, layer, 0, weight, light);
        return;
    }
    add_primaries(colours, layer, lit.rgb, light);
    if (rule == content::ReflectanceRule::five_terms) {
        add_term(colours, layer, 3, lit.features.y, light);
        add_term(colours, layer, 4, lit.features.z, light);
    } else if (rule == content::ReflectanceRule::vegetation) {
        add_term(colours, layer, 3, lit.features.x, light);
    }
}

} // namespace render

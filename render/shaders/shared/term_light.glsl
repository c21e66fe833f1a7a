// Light seen of a surface's spectral terms, by the frame's colour table; layers as render/colour/frame_colour_table.h says.
#include "shared/reflectance.glsl"
#include "shared/colour.glsl"

layout(location = 12) uniform vec2 colour_scale_and_offset;
layout(binding = 3) uniform sampler1DArray colour_table;

vec4 table_layer(float coordinate, float layer) {
    return textureLod(colour_table, vec2(coordinate, layer), 0.0);
}

// Three primaries, and what follows them: `others` holds further weights, of the fourth term on.
vec3 primaries_seen(float coordinate, float first, vec3 lit, vec4 others, int other_count) {
    vec4 red = table_layer(coordinate, first);
    vec4 green = table_layer(coordinate, first + 1.0);
    vec4 blue = table_layer(coordinate, first + 2.0);
    vec3 seen = shifted_light(lit, red.rgb, green.rgb, blue.rgb);
    if (other_count > 0) {
        seen += others.x * vec3(red.a, green.a, blue.a);
    }
    if (other_count > 1) {
        seen += others.y * table_layer(coordinate, first + 3.0).rgb;
    }
    if (other_count > 2) {
        seen += others.z * table_layer(coordinate, first + 4.0).rgb;
    }
    if (other_count > 3) {
        seen += others.w * table_layer(coordinate, first + 5.0).rgb;
    }
    return seen;
}

#ifdef DOMINANT_WAVELENGTH
// Of which of the HUES tabulated hues a hue is mixed: HueWheel (render/colour/dominant_wavelength.h).
struct HueStep {
    uint hue;
    float start;
    float per_sextant;
};
layout(std430, binding = 3) readonly buffer HueWheel { HueStep hue_steps[]; };

// White, and two hues side by side.
vec3 hues_seen(float coordinate, float first, vec3 lit) {
    vec3 hue = hue_of(lit);
    HueStep found = hue_steps[min(int(hue.z * (float(hue_steps.length()) / 6.0)), hue_steps.length() - 1)];
    float share = clamp((hue.z - found.start) * found.per_sextant, 0.0, 1.0);
    uint next = found.hue + 1u == uint(HUES) ? 0u : found.hue + 1u;
    vec3 of_hue = mix(table_layer(coordinate, first + 1.0 + float(found.hue)).rgb,
                      table_layer(coordinate, first + 1.0 + float(next)).rgb, share);
    return hue.x * table_layer(coordinate, first).rgb + hue.y * of_hue;
}
#endif

// What the eye sees of light `received` (linear RGB) sent on by a surface; `invisible`: its reflectances in the
// ultraviolet and the infrared, where it has such terms (UV, IR).
vec3 reflected_seen(float coordinate, float first, vec3 received, vec3 reflectance, vec2 invisible) {
    float y = luminance_of(received);
#if defined(OWN_SPECTRUM)
    return y * luminance_of(reflectance) * table_layer(coordinate, first).rgb;
#else
    vec3 lit = received * reflectance;
    vec2 bands = y * invisible;
#ifdef DOMINANT_WAVELENGTH
    vec3 seen = hues_seen(coordinate, first, lit);
#ifdef UV
    seen += bands.x * table_layer(coordinate, first + float(HUES + 1)).rgb;
    seen += bands.y * table_layer(coordinate, first + float(HUES + 2)).rgb;
#endif
    return seen;
#else
    vec3 features = y * reflectance_features(reflectance);
#if defined(FIVE_TERMS)
    const int count = 2;
    vec4 others = vec4(features.yz, bands);
#elif defined(VEGETATION)
    const int count = 1;
    vec4 others = vec4(features.x, bands, 0.0);
#else
    const int count = 0;
    vec4 others = vec4(bands, 0.0, 0.0);
#endif
#ifdef UV
    return primaries_seen(coordinate, first, lit, others, count + 2);
#else
    return primaries_seen(coordinate, first, lit, others, count);
#endif
#endif
#endif
}

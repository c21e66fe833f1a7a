#version 450 core
// Light of a surface: sun with shadows, slowly varying light from the vertices, lamps nearby, emission. SHIFTED: as the
// moving eye sees it, by the spectra; otherwise as it is at rest.
#include "shared/reflectance.glsl"
#include "shared/colour.glsl"
#ifdef TABLE
#include "shared/term_light.glsl"
#endif
in vec4 colour;
in vec3 light;
flat in vec4 emission_cutoff;
#if defined(TEXTURED) || defined(EMISSION_TEXTURED)
in vec2 uv;
flat in uvec2 layers;
#endif
#ifdef TEXTURED
layout(binding = 0) uniform sampler2DArray base_colours;
// The warp filters a tile's texels once more; half a mip level finer makes up for it.
const float tile_mip_bias = -0.5;
#endif
#ifdef EMISSION_TEXTURED
layout(binding = 1) uniform sampler2DArray emissions;
#endif
#ifdef SUN
in float sun_cosine;
in vec3 shadow;
layout(binding = 2) uniform sampler2DShadow shadow_map;
layout(location = 7) uniform vec3 sun_light; // irradiance / pi
#endif
layout(location = 8) uniform float gain;
layout(location = 9) uniform float coverage; // what alpha says of scenery: 1 in an atlas, 0 (no sky) on the screen
#ifdef SHIFTED
in vec3 relative;
layout(location = 10) uniform vec3 along;
layout(location = 11) uniform float exp_rapidity;
#endif
#ifdef TABLE
flat in vec2 first_layers; // of what is reflected of the first light, and of what is emitted
flat in vec4 invisible;    // ultraviolet and infrared: reflectance, emission
#endif
#ifdef NEAR_LAMPS
in vec3 world_position;
in vec3 world_normal;
flat in uint lamp_list;
struct Lamp {
    vec4 position_range;
    vec4 light; // intensity / pi; w: index of its light
};
layout(std430, binding = 1) readonly buffer Lamps { Lamp all_lamps[]; };
layout(std430, binding = 2) readonly buffer LampLists { uint lamp_indices[]; };
layout(binding = 4) uniform samplerCubeArrayShadow lamp_shadows;
#include "shared/surface_light.glsl"
#include "shared/lamp_shadow.glsl"

void add_light_of_lamps(inout vec3 received[LIGHTS]) {
    vec3 normal = normalize(world_normal);
    uint first = lamp_list >> 8u;
    for (uint i = first; i < first + (lamp_list & 255u); ++i) {
        uint index = lamp_indices[i];
        Lamp lamp = all_lamps[index];
        vec3 to_lamp = lamp.position_range.xyz - world_position;
        float share = lamp_share(to_lamp, normal, lamp.position_range.w);
        if (share > 0.0) {
            if (index < uint(SHADOWED_LAMPS)) {
                vec3 from_lamp = lamp_shadow_offset(to_lamp, float(LAMP_SHADOW_TEXELS)) * normal - to_lamp;
                share *= texture(lamp_shadows, vec4(from_lamp, float(index)), lamp_shadow_depth(from_lamp));
            }
            received[uint(lamp.light.w)] += share * lamp.light.xyz;
        }
    }
}
#endif

layout(location = 0) out vec4 radiance;

void main() {
    vec4 reflectance = colour;
#ifdef TEXTURED
    reflectance *= texture(base_colours, vec3(uv, float(layers.x)), tile_mip_bias * coverage);
#endif
#ifdef MASKED
    if (reflectance.a < emission_cutoff.w) {
        discard;
    }
#endif
#if defined(SHIFTED)
    float coordinate = colour_coordinate(wavelength_ratio_from(relative, along, exp_rapidity), colour_scale_and_offset);
#elif defined(TABLE)
    const float coordinate = 0.5; // the same colours everywhere
#endif
#ifdef UNLIT
#ifdef SHIFTED
    vec3 seen = primaries_seen(coordinate, 0.0, reflectance.rgb, vec4(0.0), 0);
#else
    vec3 seen = gain * reflectance.rgb;
#endif
#else
    vec3 received[LIGHTS];
    received[0] = light;
    for (int i = 1; i < LIGHTS; ++i) {
        received[i] = vec3(0.0);
    }
#ifdef SUN
    if (sun_cosine > 0.0) {
        received[0] += sun_light * (sun_cosine * textureLod(shadow_map, shadow, 0.0));
    }
#endif
#ifdef NEAR_LAMPS
    add_light_of_lamps(received);
#endif
#if defined(SHIFTED) || defined(OWN_SPECTRUM)
    vec3 seen = reflected_seen(coordinate, first_layers.x, received[0], reflectance.rgb, invisible.xy);
#else
    vec3 seen = gain * (reflectance.rgb * received[0]);
#endif
#if LIGHTS > 1
    for (int i = 1; i < LIGHTS; ++i) {
        seen += reflected_seen(coordinate, first_layers.x + float(i * LAYERS), received[i], reflectance.rgb, invisible.xy);
    }
#endif
#ifdef EMITS
    vec3 emitted = emission_cutoff.rgb;
#ifdef EMISSION_TEXTURED
    emitted *= texture(emissions, vec3(uv, float(layers.y))).rgb;
#endif
#if defined(EMISSION_SPECTRUM)
    seen += luminance_of(emitted) * table_layer(coordinate, first_layers.y).rgb;
#elif defined(SHIFTED) && defined(EMISSION_INVISIBLE)
    seen += primaries_seen(coordinate, first_layers.y, emitted, vec4(invisible.zw, 0.0, 0.0), 2);
#elif defined(SHIFTED)
    seen += primaries_seen(coordinate, first_layers.y, emitted, vec4(0.0), 0);
#else
    seen += gain * emitted;
#endif
#endif
#endif
    radiance = vec4(within_half_range(seen), coverage);
}

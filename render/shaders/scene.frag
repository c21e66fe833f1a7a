#version 450 core
// Radiance at rest of a surface: sun with shadows, slowly varying light from the vertices, lamps nearby, emission.
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
#ifdef NEAR_LAMPS
in vec3 world_position;
in vec3 world_normal;
flat in uint lamp_list;
struct Lamp {
    vec4 position_range;
    vec4 light; // intensity / pi
};
layout(std430, binding = 1) readonly buffer Lamps { Lamp all_lamps[]; };
layout(std430, binding = 2) readonly buffer LampLists { uint lamp_indices[]; };

vec3 light_of_lamps() {
    vec3 normal = normalize(world_normal);
    vec3 sum = vec3(0.0);
    uint first = lamp_list >> 8u;
    for (uint i = first; i < first + (lamp_list & 255u); ++i) {
        Lamp lamp = all_lamps[lamp_indices[i]];
        vec3 to_lamp = lamp.position_range.xyz - world_position;
        float distance2 = max(dot(to_lamp, to_lamp), 0.0025);
        float share2 = lamp.position_range.w > 0.0 ? distance2 / (lamp.position_range.w * lamp.position_range.w) : 0.0;
        float window = clamp(1.0 - share2 * share2, 0.0, 1.0);
        sum += lamp.light.xyz * (max(dot(normal, to_lamp), 0.0) * inversesqrt(distance2) * window / distance2);
    }
    return sum;
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
#ifdef UNLIT
    radiance = vec4(gain * reflectance.rgb, coverage);
#else
    vec3 received = light;
#ifdef SUN
    if (sun_cosine > 0.0) {
        received += sun_light * (sun_cosine * textureLod(shadow_map, shadow, 0.0));
    }
#endif
#ifdef NEAR_LAMPS
    received += light_of_lamps();
#endif
    vec3 emitted = emission_cutoff.rgb;
#ifdef EMISSION_TEXTURED
    emitted *= texture(emissions, vec3(uv, float(layers.y))).rgb;
#endif
    radiance = vec4(min(gain * (reflectance.rgb * received + emitted), vec3(60000.0)), coverage);
#endif
}

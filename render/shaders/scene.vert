#version 450 core
#include "shared/scene_clip.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coordinates;
layout(location = 3) in vec4 vertex_colour;
layout(location = 4) in vec3 vertex_light;
layout(location = 5) in uint material;
layout(location = 6) in uint lamps;

struct Material {
    vec4 emission_cutoff;
    uvec4 layers; // of the images: base colour, emission; of the colour table: reflected, emitted
    vec4 invisible;
};
layout(std430, binding = 0) readonly buffer Materials { Material materials[]; };

layout(location = 0) uniform mat3 picture_from_world;
layout(location = 1) uniform vec3 eye;
layout(location = 2) uniform vec3 eye_remainder;
layout(location = 3) uniform float near;
layout(location = 4) uniform vec3 towards_sun;
layout(location = 5) uniform mat4x3 shadow_from_world;
layout(location = 6) uniform float shadow_offset;

out vec4 colour;
out vec3 light;
flat out vec4 emission_cutoff;
#if defined(TEXTURED) || defined(EMISSION_TEXTURED)
out vec2 uv;
flat out uvec2 layers;
#endif
#ifdef SUN
out float sun_cosine;
out vec3 shadow;
#endif
#ifdef SHIFTED
out vec3 relative;
#endif
#ifdef TABLE
flat out vec2 first_layers;
flat out vec4 invisible;
#endif
#ifdef NEAR_LAMPS
out vec3 world_position;
out vec3 world_normal;
flat out uint lamp_list;
#endif

void main() {
    vec3 from_eye = (position - eye) - eye_remainder;
    gl_Position = scene_clip(picture_from_world, from_eye, near);
    colour = vertex_colour;
    light = vertex_light;
    emission_cutoff = materials[material].emission_cutoff;
#if defined(TEXTURED) || defined(EMISSION_TEXTURED)
    uv = texture_coordinates;
    layers = materials[material].layers.xy;
#endif
#ifdef SUN
    sun_cosine = dot(normal, towards_sun);
    shadow = shadow_from_world * vec4(position + shadow_offset * normal, 1.0);
#endif
#ifdef SHIFTED
    relative = from_eye;
#endif
#ifdef TABLE
    first_layers = vec2(materials[material].layers.zw);
    invisible = materials[material].invisible;
#endif
#ifdef NEAR_LAMPS
    world_position = position;
    world_normal = normal;
    lamp_list = lamps;
#endif
}

#version 450 core
#include "shared/scene_clip.glsl"

layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texture_coordinates;
layout(location = 3) in vec4 vertex_colour;
layout(location = 5) in uint material;
layout(location = 7) in uint object;

struct Material {
    vec4 emission_cutoff;
    uvec4 layers;
    vec4 invisible;
};
layout(std430, binding = 0) readonly buffer Materials { Material materials[]; };

layout(location = 0) uniform mat3 picture_from_world;
layout(location = 1) uniform vec3 eye;
layout(location = 2) uniform vec3 eye_remainder;
layout(location = 3) uniform float near;

out vec3 relative;
out vec2 uv;
out float alpha;
flat out float object_index;
flat out float layer;
flat out float cutoff;

void main() {
    relative = (position - eye) - eye_remainder;
    gl_Position = scene_clip(picture_from_world, relative, near);
    uv = texture_coordinates;
    alpha = vertex_colour.a;
    object_index = float(object);
    layer = float(materials[material].layers.x);
    cutoff = materials[material].emission_cutoff.w;
}

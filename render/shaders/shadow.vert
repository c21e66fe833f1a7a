#version 450 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texture_coordinates;
layout(location = 3) in vec4 vertex_colour;
layout(location = 5) in uint material;

struct Material {
    vec4 emission_cutoff;
    uvec4 layers;
    vec4 invisible;
};
layout(std430, binding = 0) readonly buffer Materials { Material materials[]; };

layout(location = 5) uniform mat4x3 shadow_from_world; // to [0, 1]^3

out vec2 uv;
out float alpha;
flat out float layer;
flat out float cutoff;

void main() {
    vec3 s = shadow_from_world * vec4(position, 1.0);
    gl_Position = vec4(2.0 * s.xy - 1.0, s.z, 1.0);
    uv = texture_coordinates;
    alpha = vertex_colour.a;
    layer = float(materials[material].layers.x);
    cutoff = materials[material].emission_cutoff.w;
}

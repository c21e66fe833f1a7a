#version 450 core
// A factor on the finished picture: narrowed towards where the eye looks, and dimmed.
#include "shared/comfort.glsl"

in vec2 ndc;

layout(location = 0) uniform vec4 tangents; // left, right, down, up
layout(location = 1) uniform float narrowing;
layout(location = 2) uniform float fade;

layout(location = 0) out vec4 colour;

void main() {
    vec2 place = 0.5 * ndc + 0.5;
    float from_axis = length(mix(tangents.xz, tangents.yw, place));
    colour = vec4(vec3((1.0 - fade) * vignette_light(from_axis, narrowing)), 1.0);
}

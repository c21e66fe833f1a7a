#version 450 core
// The last pass: exposed, through the tone curve, encoded.
#include "shared/display.glsl"

in vec2 ndc;

layout(location = 0) uniform float exposure; // on top of what is baked into the light
layout(location = 1) uniform bool filmic_curve;

layout(binding = 0) uniform sampler2D light;

layout(location = 0) out vec4 colour;

void main() {
    vec3 exposed = exposure * textureLod(light, 0.5 * ndc + 0.5, 0.0).rgb;
    colour = vec4(display_colour(exposed, filmic_curve), 1.0);
}

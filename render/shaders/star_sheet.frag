#version 450 core
// Lays the stars computed on the CPU over the sky; blending multiplies by the sky's visibility.
#include "shared/colour.glsl"

in vec2 ndc;

layout(binding = 0) uniform sampler2D stars; // rows from the top, size of the picture

layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(within_half_range(textureLod(stars, vec2(0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y), 0.0).rgb), 0.0);
}

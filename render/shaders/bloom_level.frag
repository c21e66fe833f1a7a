#version 450 core
// One level of the bloom's pyramid from its neighbour. Between the centres of four finer cells linear filtering is
// their mean; at the centre of a finer cell it weights the coarser ones by 9/16, 3/16, 3/16, 1/16, which hands on every
// coarse cell's light whole.
in vec2 ndc;

layout(binding = 0) uniform sampler2D other_level; // linear filter, clamped

layout(location = 0) out vec4 light;

void main() {
    light = textureLod(other_level, 0.5 * ndc + 0.5, 0.0);
}

#version 450 core
// The cabin's smoothed picture over what is there; where it does not cover a pixel its alpha lets that through.
layout(binding = 0) uniform sampler2D cabin;

layout(location = 0) out vec4 colour;

in vec2 ndc;

void main() {
    colour = textureLod(cabin, 0.5 * ndc + 0.5, 0.0);
}

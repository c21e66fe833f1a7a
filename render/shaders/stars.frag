#version 450 core
#include "shared/star.glsl"

flat in vec2 centre;
flat in vec3 light;

layout(location = 0) out vec4 colour;

void main() {
    colour = vec4(light * star_share(gl_FragCoord.xy - centre), 0.0);
}

#version 450 core
// Light of a ship as the eye sees it; or, for data layers, its distance and number.
#include "shared/colour.glsl"

in vec3 relative;
in vec3 light;
flat in float object_index;

#ifdef DATA
layout(location = 0) out vec2 distance_and_object;

void main() {
    distance_and_object = vec2(length(relative), object_index);
}
#else
layout(location = 8) uniform float gain;
layout(location = 9) uniform float coverage;
layout(location = 0) out vec4 radiance;

void main() {
    radiance = vec4(within_half_range(gain * light), coverage);
}
#endif

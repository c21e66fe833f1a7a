#version 450 core
// The cabin, at rest with the pilot: an ordinary perspective of the eye in it, asymmetric where its screen is.
#include "shared/cabin_clip.glsl"

layout(location = 0) in vec3 position; // cabin frame, metres
#ifdef SCREEN
layout(location = 1) in vec2 panel_place; // from the upper left corner
out vec2 place;
#else
layout(location = 1) in vec4 vertex_light; // radiance sent out, and how open the vertex is to the outside
layout(location = 2) in vec3 vertex_normal;
out vec4 light;
out vec3 normal;
out vec3 from_eye;
#endif

layout(location = 0) uniform mat3 eye_from_cabin;
layout(location = 1) uniform vec3 eye;
layout(location = 2) uniform vec4 tangents; // left, right, down, up
layout(location = 3) uniform float near;

void main() {
    gl_Position = cabin_clip(eye_from_cabin * (position - eye), tangents, near);
#ifdef SCREEN
    place = vec2(panel_place.x, 1.0 - panel_place.y);
#else
    light = vertex_light;
    normal = vertex_normal;
    from_eye = position - eye;
#endif
}

#version 450 core
// A ship as its light paints it in the world (render/moving/seen_ships.h), beside the scenery in the same pictures.
#include "shared/scene_clip.glsl"

layout(location = 0) in vec3 from_eye;
layout(location = 1) in vec3 radiance;
layout(location = 2) in float object;

layout(location = 0) uniform mat3 picture_from_world;
layout(location = 3) uniform float near;

out vec3 relative;
out vec3 light;
flat out float object_index;

void main() {
    gl_Position = scene_clip(picture_from_world, from_eye, near);
    relative = from_eye;
    light = radiance;
    object_index = object;
}

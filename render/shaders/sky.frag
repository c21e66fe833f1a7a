#version 450 core
// The sky alone, where a plain frame has no scenery.
#include "shared/pixel_ray.glsl"
#include "shared/frame_light.glsl"

layout(location = 0) out vec4 light; // alpha: how much of the sky is to be seen

void main() {
    vec3 ray = pixel_ray();
    SeenLight seen = see_along_z(normalize(ray), exp_rapidity);
    vec3 world_direction = world_from_axis * (seen.direction_times_ratio / seen.wavelength_ratio);
    light = vec4(within_half_range(sky_light(world_direction, seen.wavelength_ratio, ray)), 1.0);
}

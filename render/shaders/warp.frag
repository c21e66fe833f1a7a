#version 450 core
// Second step of the texture method: what a pixel of the moving eye sees, from the pictures of the world that it passes.
#include "shared/pixel_ray.glsl"
#include "shared/frame_light.glsl"

flat in vec3 atlas_row_0;
flat in vec3 atlas_row_1;
flat in vec3 atlas_row_2;

layout(binding = 0) uniform sampler2D atlas;

layout(location = 0) out vec4 light; // alpha: how much of the sky is to be seen

void main() {
    vec3 ray = pixel_ray();
    SeenLight seen = see_along_z(normalize(ray), exp_rapidity);
    vec3 n_d = seen.direction_times_ratio;
    vec4 seen_scenery = textureLod(atlas, tile_coordinates(atlas_row_0, atlas_row_1, atlas_row_2, n_d), 0.0);
    vec3 radiance = seen_scenery.rgb;
    if (seen_scenery.a < 1.0) {
        vec3 world_direction = world_from_axis * (n_d / seen.wavelength_ratio);
        radiance += (1.0 - seen_scenery.a) * sky_light(world_direction, seen.wavelength_ratio, ray);
    }
    light = vec4(within_half_range(radiance), 1.0 - seen_scenery.a);
}

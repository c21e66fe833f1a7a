#version 450 core
// Data of the moving eye: by `wanted` (render::WarpData) D, distance and object; the world direction; or D and where
// in the atlas the pixel looks.
#include "shared/pixel_ray.glsl"

flat in vec3 atlas_row_0;
flat in vec3 atlas_row_1;
flat in vec3 atlas_row_2;

layout(binding = 0) uniform sampler2D atlas; // distance, object; nearest
layout(location = 10) uniform int wanted;

layout(location = 0) out vec4 data;

void main() {
    SeenLight seen = see_along_z(normalize(pixel_ray()), exp_rapidity);
    vec3 n_d = seen.direction_times_ratio;
    if (wanted == 1) {
        data = vec4(world_from_axis * normalize(n_d), 0.0);
        return;
    }
    vec2 coordinates = tile_coordinates(atlas_row_0, atlas_row_1, atlas_row_2, n_d);
    data = vec4(seen.wavelength_ratio, wanted == 2 ? coordinates : textureLod(atlas, coordinates, 0.0).xy, 0.0);
}

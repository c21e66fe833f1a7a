#version 450 core
// Data layers of the moving eye: (D, distance, object, 0) or the world direction.
#include "shared/pixel_ray.glsl"

flat in vec3 atlas_row_0;
flat in vec3 atlas_row_1;
flat in vec3 atlas_row_2;

layout(binding = 0) uniform sampler2D atlas; // distance, object; nearest
layout(location = 10) uniform int direction_wanted;

layout(location = 0) out vec4 data;

void main() {
    SeenLight seen = see_along_z(normalize(pixel_ray()), exp_rapidity);
    vec3 n_d = seen.direction_times_ratio;
    if (direction_wanted != 0) {
        data = vec4(world_from_axis * normalize(n_d), 0.0);
        return;
    }
    vec3 atlas_h = vec3(dot(atlas_row_0, n_d), dot(atlas_row_1, n_d), dot(atlas_row_2, n_d));
    data = vec4(seen.wavelength_ratio, textureLod(atlas, atlas_h.xy / atlas_h.z, 0.0).xy, 0.0);
}

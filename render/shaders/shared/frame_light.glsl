// From light at rest to light seen: colour table and sky, with the uniforms and textures they need.
#include "shared/colour.glsl"
#include "shared/sky_gradient.glsl"
#include "shared/sky_lod.glsl"

layout(location = 5) uniform vec2 colour_scale_and_offset;
layout(binding = 1) uniform sampler1DArray colour_table;
layout(location = 6) uniform float sky_texels_per_pixel;
layout(location = 7) uniform vec3 zenith;
layout(location = 8) uniform vec3 horizon;
layout(location = 9) uniform vec3 nadir;
#ifdef PANORAMA
layout(binding = 2) uniform samplerCube sky_cube;
#endif

vec3 sky_at_rest(vec3 world_direction, float wavelength_ratio, vec3 ray) {
#ifdef PANORAMA
    return textureLod(sky_cube, world_direction, sky_lod(sky_texels_per_pixel, wavelength_ratio, ray)).rgb;
#else
    return gradient_sky_radiance(world_direction.y, zenith, horizon, nadir);
#endif
}

vec3 seen_light(vec3 at_rest, float wavelength_ratio) {
    float coordinate = colour_coordinate(wavelength_ratio, colour_scale_and_offset);
    return within_half_range(shifted_light(at_rest, textureLod(colour_table, vec2(coordinate, 0.0), 0.0).rgb,
                                           textureLod(colour_table, vec2(coordinate, 1.0), 0.0).rgb,
                                           textureLod(colour_table, vec2(coordinate, 2.0), 0.0).rgb));
}

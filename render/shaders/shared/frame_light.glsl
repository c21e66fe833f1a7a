// The sky, and its light as seen, with the uniforms and textures they need.
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

// What the eye sees of the sky; pre-exposed.
vec3 sky_light(vec3 world_direction, float wavelength_ratio, vec3 ray) {
    vec3 at_rest = sky_at_rest(world_direction, wavelength_ratio, ray);
    float coordinate = colour_coordinate(wavelength_ratio, colour_scale_and_offset);
    vec3 seen = shifted_light(at_rest, textureLod(colour_table, vec2(coordinate, 0.0), 0.0).rgb,
                              textureLod(colour_table, vec2(coordinate, 1.0), 0.0).rgb,
                              textureLod(colour_table, vec2(coordinate, 2.0), 0.0).rgb);
#ifdef MICROWAVE_LAYER
    seen += textureLod(colour_table, vec2(coordinate, float(MICROWAVE_LAYER)), 0.0).rgb;
#endif
    return seen;
}

// The boosted view's uniforms, and what a pixel sees by them.
#include "shared/warp.glsl"

layout(location = 0) uniform vec3 ray_origin; // eye ray of the screen's lower left corner, axis frame
layout(location = 1) uniform vec3 ray_right;  // its change a pixel
layout(location = 2) uniform vec3 ray_up;
layout(location = 3) uniform float exp_rapidity;
layout(location = 4) uniform mat3 world_from_axis;

// Unnormalised: 1 / cos of the angle off the screen's axis long.
vec3 pixel_ray() {
    return ray_origin + gl_FragCoord.x * ray_right + gl_FragCoord.y * ray_up;
}

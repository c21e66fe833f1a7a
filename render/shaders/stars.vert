#version 450 core
// One point a star: where it is seen, how bright and of what colour.
#include "shared/colour.glsl"
#include "shared/star.glsl"

layout(location = 0) in vec3 position;           // light-years, world
layout(location = 1) in vec3 position_remainder; // what single precision cut off
layout(location = 2) in vec2 source;             // ln strength, ln temperature

layout(location = 0) uniform vec3 eye; // light-years, world
layout(location = 1) uniform vec3 eye_remainder;
layout(location = 2) uniform vec3 along;
layout(location = 3) uniform float exp_rapidity;
layout(location = 4) uniform mat3 head_from_boosted;
layout(location = 5) uniform vec3 axis;       // of the eye on the screen: pixels from the lower left corner; focal length
layout(location = 6) uniform vec2 size;       // of the picture, pixels
layout(location = 7) uniform vec2 mode;       // temperature shift, exponent of D
layout(location = 8) uniform vec2 coordinate; // scale and offset on ln T
layout(location = 9) uniform float pre_exposure;
layout(location = 10) uniform float faintest; // exposed radiance that no display shows

layout(binding = 0) uniform sampler1D black_bodies;

flat out vec2 centre; // window coordinates within the picture
flat out vec3 light;  // radiance if all of it fell into one pixel

void main() {
    vec3 offset = (position - eye) + (position_remainder - eye_remainder);
    vec4 seen = star_seen(offset, along, exp_rapidity);
    vec3 direction = head_from_boosted * seen.xyz;
    float ln_ratio = log(seen.w);

    vec4 body = textureLod(black_bodies, coordinate.x * (source.y - mode.x * ln_ratio) + coordinate.y, 0.0);
    float strength = exp(source.x + body.w + mode.y * ln_ratio - log(dot(offset, offset)));
    float pixel = pixel_solid_angle(-direction.z, axis.z);
    light = within_half_range(body.xyz * (strength * pre_exposure / pixel));

    centre = axis.xy + axis.z / -direction.z * direction.xy;
    vec2 ndc = 2.0 * centre / size - 1.0;
    // A star just outside still lights pixels inside: the viewport is wider by the margin than the picture.
    vec2 widened = ndc * size / (size + star_footprint);
    bool shown = direction.z < 0.0 && max(light.x, max(light.y, light.z)) * star_share(vec2(0.0)) > faintest;
    gl_Position = vec4(shown ? widened : vec2(2.0), 0.0, 1.0);
}

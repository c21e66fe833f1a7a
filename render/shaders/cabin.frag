#version 450 core
// The cabin's surfaces: matte, under a thin gloss that mirrors what comes from around; exposed and encoded as the picture
// around them. The screens shine by themselves, as bright as the display.
#include "shared/display.glsl"

#ifdef SCREEN
in vec2 place;
layout(binding = 0) uniform sampler2D panel; // encoded
#else
in vec4 light;
in vec3 normal;
in vec3 from_eye;
layout(binding = 0) uniform samplerCube around;
layout(location = 4) uniform float exposure;
layout(location = 5) uniform bool filmic_curve;
layout(location = 6) uniform float brightest;

// Schlick's Fresnel reflectance of a gloss of refractive index 1.5, less what its roughness leaves to the matte below.
float mirrored(float cosine) {
    float away = 1.0 - clamp(cosine, 0.0, 1.0);
    float away2 = away * away;
    return 0.5 * (0.04 + 0.96 * away2 * away2 * away);
}
#endif

layout(location = 0) out vec4 colour;

void main() {
#ifdef SCREEN
    colour = vec4(texture(panel, place).rgb, 1.0);
#else
    vec3 facing = normalize(normal);
    vec3 along = normalize(from_eye);
    vec3 outside = texture(around, reflect(along, facing)).rgb;
    float share = light.a * mirrored(-dot(along, facing));
    vec3 encoded = display_colour(exposure * mix(light.rgb, outside, share), filmic_curve, brightest, srgb_gamut());
    colour = vec4(display_steps(encoded, dither_threshold(floor(gl_FragCoord.xy))) / 255.0, 1.0);
#endif
}

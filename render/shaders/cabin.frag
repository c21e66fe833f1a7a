#version 450 core
// The cabin's matte surfaces: light as it is sent out, exposed and encoded as the picture around it. The screens shine by
// themselves, as bright as the display.
#include "shared/display.glsl"

#ifdef SCREEN
in vec2 place;
layout(binding = 0) uniform sampler2D panel; // encoded
#else
in vec3 radiance;
layout(location = 4) uniform float exposure;
layout(location = 5) uniform bool filmic_curve;
#endif
layout(location = 6) uniform float brightest;

layout(location = 0) out vec4 colour;

void main() {
#ifdef SCREEN
    colour = vec4(texture(panel, place).rgb, 1.0);
#else
    vec3 encoded = display_colour(exposure * radiance, filmic_curve, srgb_gamut());
    colour = vec4(quantised(encoded, dither_threshold(floor(gl_FragCoord.xy))), 1.0);
#endif
}

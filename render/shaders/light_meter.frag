#version 450 core
// Mean luminance of a square of 8 x 8 pixels, and its brightest 2 x 2. Pixel by pixel: software OpenGL filters at several
// times the cost.
#include "shared/display.glsl"

layout(location = 0) uniform ivec2 last; // pixel of the picture

layout(binding = 0) uniform sampler2D picture;

layout(location = 0) out vec2 mean_and_brightest;

vec3 light_at(ivec2 pixel) {
    return texelFetch(picture, min(pixel, last), 0).rgb;
}

void main() {
    ivec2 corner = ivec2(gl_FragCoord.xy) * 8;
    vec2 result = vec2(0.0);
    for (int y = 0; y < 8; y += 2) {
        for (int x = 0; x < 8; x += 2) {
            ivec2 spot = corner + ivec2(x, y);
            vec3 four = light_at(spot) + light_at(spot + ivec2(1, 0)) + light_at(spot + ivec2(0, 1)) +
                        light_at(spot + ivec2(1, 1));
            float light = max(0.25 * luminance(four), 0.0);
            result = vec2(result.x + light / 16.0, max(result.y, light));
        }
    }
    mean_and_brightest = result;
}

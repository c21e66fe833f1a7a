#version 450 core
// Mean luminance of a square of 8 x 8 pixels, and its brightest 2 x 2: 16 taps, each between four pixels.
#include "shared/display.glsl"

layout(location = 0) uniform vec2 pixel; // 1 / size of the picture

layout(binding = 0) uniform sampler2D picture; // linear filter, clamped

layout(location = 0) out vec2 mean_and_brightest;

void main() {
    vec2 corner = floor(gl_FragCoord.xy) * 8.0;
    vec2 result = vec2(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            vec3 tap = textureLod(picture, (corner + vec2(2 * x + 1, 2 * y + 1)) * pixel, 0.0).rgb;
            float light = max(luminance(tap), 0.0);
            result = vec2(result.x + light / 16.0, max(result.y, light));
        }
    }
    mean_and_brightest = result;
}

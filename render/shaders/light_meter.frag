#version 450 core
// Mean luminance of a square of 8 x 8 pixels: 16 taps, each between four pixels.
#include "shared/display.glsl"

layout(location = 0) uniform vec2 pixel; // 1 / size of the picture

layout(binding = 0) uniform sampler2D picture; // linear filter, clamped

layout(location = 0) out float mean_luminance;

void main() {
    vec2 corner = floor(gl_FragCoord.xy) * 8.0;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            sum += textureLod(picture, (corner + vec2(2 * x + 1, 2 * y + 1)) * pixel, 0.0).rgb;
        }
    }
    mean_luminance = max(luminance(sum) / 16.0, 0.0);
}

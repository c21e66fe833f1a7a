#version 450 core
// The finest level of the bloom's pyramid: means over cells between one and two pixels long.
#include "shared/bloom.glsl"

layout(location = 0) uniform vec2 pixels_per_cell;

layout(binding = 0) uniform sampler2D light;

layout(location = 0) out vec4 mean;

void main() {
    vec2 low = floor(gl_FragCoord.xy) * pixels_per_cell;
    vec2 high = low + pixels_per_cell;
    ivec2 first = ivec2(low);
    ivec2 last = textureSize(light, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int y = first.y; y < min(first.y + 3, int(ceil(high.y))); ++y) {
        float height = bloom_overlap(float(y), low.y, high.y);
        for (int x = first.x; x < min(first.x + 3, int(ceil(high.x))); ++x) {
            sum += height * bloom_overlap(float(x), low.x, high.x) * texelFetch(light, min(ivec2(x, y), last), 0).rgb;
        }
    }
    mean = vec4(sum / (pixels_per_cell.x * pixels_per_cell.y), 1.0);
}

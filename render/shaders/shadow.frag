#version 450 core
in vec2 uv;
in float alpha;
flat in float layer;
flat in float cutoff;
#ifdef TEXTURED
layout(binding = 0) uniform sampler2DArray base_colours;
#endif

void main() {
#ifdef MASKED
    float opacity = alpha;
#ifdef TEXTURED
    opacity *= texture(base_colours, vec3(uv, layer)).a;
#endif
    if (opacity < cutoff) {
        discard;
    }
#endif
}

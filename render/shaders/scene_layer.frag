#version 450 core
// Distance from the eye and object index of a surface, for data layers.
in vec3 relative;
in vec2 uv;
in float alpha;
flat in float object_index;
flat in float layer;
flat in float cutoff;
#ifdef TEXTURED
layout(binding = 0) uniform sampler2DArray base_colours;
#endif
layout(location = 0) out vec2 distance_and_object;

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
    distance_and_object = vec2(length(relative), object_index);
}

#version 450 core
// One triangle that covers the screen; draw three vertices with no attributes bound.
out vec2 ndc;

void main() {
    ndc = vec2(gl_VertexID == 1 ? 3.0f : -1.0f, gl_VertexID == 2 ? 3.0f : -1.0f);
    gl_Position = vec4(ndc, 0.0f, 1.0f);
}

// Clip coordinates of a point given in an eye's axes (x right, y up, -z ahead) for a view whose edges lie at the tangents
// (left, right, down, up); depth is reversed, 1 at `near` and 0 infinitely far. Also compiles as C++.
vec4 cabin_clip(vec3 point, vec4 tangents, float near) {
    float width = tangents.y - tangents.x;
    float height = tangents.w - tangents.z;
    return vec4((2.0f * point.x + (tangents.x + tangents.y) * point.z) / width,
                (2.0f * point.y + (tangents.z + tangents.w) * point.z) / height, near, -point.z);
}

// Clip coordinates of a point relative to the eye under a projective picture: x and y as the map says, depth
// near / w. Reversed depth (1 at the near plane, 0 at infinity) keeps float depth exact, and along every eye ray w
// grows with distance whatever the picture plane's slant. Also compiles as C++.
vec4 scene_clip(mat3 picture_from_world, vec3 relative, float near) {
    vec3 h = picture_from_world * relative;
    return vec4(h.x, h.y, near, h.z);
}

// Shadow maps of point lamps: cubes of depth about each lamp. Also compiles as C++.

// Depth in a lamp's cube: near / (distance along the face's axis), so that 1 is the clearance and 0 infinity.
const float lamp_shadow_near = 0.4f; // content::lamp_clearance
float lamp_shadow_depth(vec3 from_lamp) {
    vec3 size = abs(from_lamp);
    return lamp_shadow_near / max(max(size.x, size.y), max(size.z, lamp_shadow_near));
}

// How far off its surface a point looks up a lamp's shadow: a bit more than a texel of the map is wide there.
float lamp_shadow_offset(vec3 to_lamp, float texels) {
    return 3.0f / texels * sqrt(dot(to_lamp, to_lamp));
}

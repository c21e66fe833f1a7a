// The eye ray of a point on the screen. `ndc` in [-1, 1]^2, y up; `half_extent` = tangents of half the fields of view.
// Head axes: x right, y up, -z ahead. Not normalised: its length is 1 / cos(angle off the axis).
vec3 head_ray_of_ndc(vec2 ndc, vec2 half_extent) {
    return vec3(ndc.x * half_extent.x, ndc.y * half_extent.y, -1.0f);
}

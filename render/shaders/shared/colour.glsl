// Colour under Doppler shift by the frame's table (render/colour/frame_colour_table.h). Also compiles as C++.

// Texture coordinate of D in the frame's colour table; scale_and_offset as the table says.
float colour_coordinate(float wavelength_ratio, vec2 scale_and_offset) {
    return scale_and_offset.x * log2(wavelength_ratio) + scale_and_offset.y;
}

// Light of linear RGB at rest, seen: its components times what the table's three layers hold at D.
vec3 shifted_light(vec3 at_rest, vec3 of_red, vec3 of_green, vec3 of_blue) {
    return at_rest.x * of_red + at_rest.y * of_green + at_rest.z * of_blue;
}

// Keeps light within a half float's range without changing its hue.
vec3 within_half_range(vec3 light) {
    float peak = max(max(abs(light.x), abs(light.y)), abs(light.z));
    return peak > 60000.0f ? light * (60000.0f / peak) : light;
}

// Aberration and Doppler without trigonometry and without cancellation (PHYSICS 4, RENDERING 'Formulas').
// The functions of this file also compile as C++ with GLM, where tests compare them with double precision.

struct SeenLight {
    vec3 direction_times_ratio; // n D: where the light comes from in the world, times D; world's boost axes
    float wavelength_ratio;     // D = lambda_observed / lambda_emitted
};

// `seen`: unit vector where the eye sees light coming from, in boosted axes whose z is the direction of motion.
// `exp_rapidity`: e^xi. Half angles as |seen - z|^2 / 4, never as 1 - cos.
SeenLight see_along_z(vec3 seen, float exp_rapidity) {
    float aside2 = seen.x * seen.x + seen.y * seen.y;
    float sin2_half = 0.25f * (aside2 + (seen.z - 1.0f) * (seen.z - 1.0f));
    float cos2_half = 0.25f * (aside2 + (seen.z + 1.0f) * (seen.z + 1.0f));
    float ahead = cos2_half / exp_rapidity;
    float behind = sin2_half * exp_rapidity;
    SeenLight light;
    light.direction_times_ratio = vec3(seen.x, seen.y, ahead - behind);
    light.wavelength_ratio = ahead + behind;
    return light;
}

// Texture coordinates of a direction in a tile: a projective map, given by its rows, homogeneous in the direction.
vec2 tile_coordinates(vec3 row_0, vec3 row_1, vec3 row_2, vec3 direction) {
    return vec2(dot(row_0, direction), dot(row_1, direction)) / dot(row_2, direction);
}

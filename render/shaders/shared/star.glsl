// Stars as points. Also compiles as C++.

// Where a star at `offset` from the eye's event (world axes, any length unit) is seen: unit direction in the boosted
// frame, and D = lambda_observed / lambda_emitted. The eye moves along the unit vector `along` with rapidity
// ln(exp_rapidity). 1 +- cos are sums of squares, so nothing cancels at any speed; no trigonometry (PHYSICS 4).
vec4 star_seen(vec3 offset, vec3 along, float exp_rapidity) {
    vec3 n = normalize(offset);
    vec3 ahead = n + along;
    vec3 behind = n - along;
    float p = 0.25f * dot(ahead, ahead) * exp_rapidity;
    float q = 0.25f * dot(behind, behind) / exp_rapidity;
    float wavelength_ratio = 1.0f / (p + q);
    return vec4(wavelength_ratio * (n + along * (p - q - dot(n, along))), wavelength_ratio);
}

// Quintic B-spline, support (-3, 3), standard deviation 0.707: its values at any points one apart sum to exactly 1.
float spline_weight(float x) {
    float a = max(3.0f - abs(x), 0.0f);
    float b = max(2.0f - abs(x), 0.0f);
    float c = max(1.0f - abs(x), 0.0f);
    return (a * a * a * a * a - 6.0f * b * b * b * b * b + 15.0f * c * c * c * c * c) / 120.0f;
}

// Share of a star's light in a pixel whose centre is `from_star` pixels away. The shares of all pixels sum to 1
// wherever the star lies between them, so a moving star neither blinks nor smears.
float star_share(vec2 from_star) {
    return spline_weight(from_star.x) * spline_weight(from_star.y);
}

// Side of the square of pixels that star_share covers.
const float star_footprint = 6.0f;

// Solid angle of a pixel, steradian: `focal_pixels` pixels a unit tangent, at an angle off the screen's axis.
float pixel_solid_angle(float cos_off_axis, float focal_pixels) {
    return cos_off_axis * cos_off_axis * cos_off_axis / (focal_pixels * focal_pixels);
}

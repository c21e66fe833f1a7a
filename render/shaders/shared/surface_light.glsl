// How light falls on surfaces at rest. Also compiles as C++.

// Share of the constant sky light that a surface gets, by the height of its unit normal.
float ambient_share(float up) {
    return 0.65f + 0.35f * up;
}

// What a lamp of unit intensity gives a surface: cos / d^2, faded out towards the lamp's range (0: unlimited), the
// distance at least 5 cm. Irradiance where the intensity is radiant intensity.
float lamp_share(vec3 to_lamp, vec3 unit_normal, float range) {
    float distance2 = max(dot(to_lamp, to_lamp), 0.0025f);
    float share2 = range > 0.0f ? distance2 / (range * range) : 0.0f;
    float window = clamp(1.0f - share2 * share2, 0.0f, 1.0f);
    return max(dot(unit_normal, to_lamp), 0.0f) * window / (distance2 * sqrt(distance2));
}

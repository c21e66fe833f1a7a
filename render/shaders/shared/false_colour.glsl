// Pictures of numbers: false colours, and lines of equal value. Encoded sRGB. Also compiles as C++.

// D as a colour: white at D = 1, blue below to red above; log2 D from -range to range. Lightness falls the same on both
// sides, so that it tells the size of the shift and hue its sign.
vec3 shift_colour(float log2_ratio, float range) {
    float x = clamp(log2_ratio / range, -1.0f, 1.0f);
    float t = abs(x);
    vec3 pale = x < 0.0f ? vec3(0.45f, 0.70f, 0.95f) : vec3(0.98f, 0.62f, 0.42f);
    vec3 deep = x < 0.0f ? vec3(0.05f, 0.13f, 0.45f) : vec3(0.42f, 0.03f, 0.08f);
    return t < 0.5f ? mix(vec3(0.96f), pale, 2.0f * t) : mix(pale, deep, 2.0f * t - 1.0f);
}

// Brightness as a colour, lightness growing all the way; x from 0 to 1.
vec3 brightness_colour(float x) {
    float t = 4.0f * clamp(x, 0.0f, 1.0f);
    vec3 low = mix(vec3(0.02f, 0.02f, 0.05f), vec3(0.28f, 0.10f, 0.50f), min(t, 1.0f));
    vec3 middle = mix(low, vec3(0.83f, 0.22f, 0.38f), clamp(t - 1.0f, 0.0f, 1.0f));
    vec3 high = mix(middle, vec3(0.98f, 0.66f, 0.22f), clamp(t - 2.0f, 0.0f, 1.0f));
    return mix(high, vec3(1.0f, 0.99f, 0.85f), clamp(t - 3.0f, 0.0f, 1.0f));
}

// Middle of the band between two iso-lines that a level lies in; the lines are at whole multiples of `step`.
float band_middle(float level, float step) {
    return step * (floor(level / step) + 0.5f);
}

// How much of a pixel a line covers that is drawn where `level` is a whole multiple of `step`: one and a half pixels
// wide, smooth at its edges. `change`: length of the level's gradient, per pixel; below 2e-6 it is single precision's
// rounding, and no line (at rest D is 1 everywhere).
float iso_line(float level, float step, float change) {
    float position = level / step;
    float off = abs(position - floor(position + 0.5f)) * step;
    return change > 2e-6f ? clamp(1.25f - off / change, 0.0f, 1.0f) : 0.0f;
}

// Lines of false-colour pictures are dark, those over a natural picture light and thinner to the eye.
vec3 with_line(vec3 colour, float coverage, bool over_light) {
    return mix(colour, over_light ? vec3(1.0f, 0.95f, 0.55f) : vec3(0.08f), (over_light ? 0.75f : 0.9f) * coverage);
}

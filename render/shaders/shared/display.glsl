// From linear light to what a display is given. Also compiles as C++.

float luminance(vec3 rgb) {
    return dot(rgb, vec3(0.2126f, 0.7152f, 0.0722f));
}

// A colour outside the gamut (a negative component) moves towards the grey of its own luminance until it is inside:
// hue and luminance stay, saturation gives way. Light without luminance is black.
vec3 within_gamut(vec3 rgb) {
    float grey = max(luminance(rgb), 0.0f);
    float lowest = min(min(rgb.x, rgb.y), rgb.z);
    float saturation = lowest < 0.0f ? grey / (grey - lowest) : 1.0f;
    return max(vec3(grey) + saturation * (rgb - vec3(grey)), vec3(0.0f));
}

// Filmic shoulder on the largest component, so hue stays: the identity up to 0.5, then a hyperbola that reaches 1 at
// infinity with the same slope at 0.5. What is squeezed loses saturation towards white, as film and the eye do.
vec3 filmic(vec3 rgb) {
    float peak = max(max(rgb.x, rgb.y), max(rgb.z, 1e-6f));
    float squeezed = peak > 0.5f ? 1.0f - 0.25f / peak : peak;
    float whitening = 1.0f - 1.0f / (1.0f + 0.12f * (peak - squeezed));
    vec3 scaled = rgb * (squeezed / peak);
    return scaled + whitening * (vec3(squeezed) - scaled);
}

// sRGB transfer function (IEC 61966-2-1), linear to encoded, clamped to [0, 1]. The power 1/2.4 is fitted by roots, which
// cost a third: within 3.5e-5, a hundredth of an 8-bit step.
vec3 srgb_encoded(vec3 linear) {
    vec3 x = clamp(linear, 0.0f, 1.0f);
    vec3 root = sqrt(x);
    vec3 fourth_root = sqrt(root);
    vec3 power = 1.1226675f * root + 0.1961438f * fourth_root - 0.3354939f * root * fourth_root + 0.0813302f * x;
    return mix(12.92f * x, power - 0.0646129f, greaterThan(x, vec3(0.0031308f)));
}

// Exposed linear light to encoded colour; filmic_curve: 1 or 0 (linear, clipped at 1).
vec3 display_colour(vec3 exposed, bool filmic_curve) {
    vec3 inside = within_gamut(exposed);
    vec3 curved = filmic_curve ? filmic(inside) : inside;
    return srgb_encoded(curved);
}

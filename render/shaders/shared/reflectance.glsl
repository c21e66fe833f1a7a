// From RGB reflectances to weights of spectral terms (content/reflectance.h). Also compiles as C++.

float luminance_of(vec3 rgb) {
    return dot(rgb, vec3(0.2126f, 0.7152f, 0.0722f));
}

// What tells surfaces apart in the invisible: how much the square root of the luminance exceeds it (mid tones); first of
// leaves, whose term reaches 2, so that the reflectance stays within 1; then times how green and times how red it is.
vec3 reflectance_features(vec3 rgb) {
    float y = luminance_of(rgb);
    float most = max(max(rgb.x, rgb.y), max(rgb.z, 1e-6f));
    float middle = sqrt(y) - y;
    float green = smoothstep(0.0f, 0.4f, (rgb.y - max(rgb.x, rgb.z)) / most);
    float red = clamp((rgb.x - rgb.z) / most, 0.0f, 1.0f);
    return vec3(min(middle, 0.5f * (1.0f - most)), middle * green, middle * red);
}

// Least component, chroma (greatest less least) and hue: red 0, yellow 1, green 2, cyan 3, blue 4, magenta 5, up to 6.
vec3 hue_of(vec3 rgb) {
    float least = min(rgb.x, min(rgb.y, rgb.z));
    float most = max(rgb.x, max(rgb.y, rgb.z));
    float chroma = most - least;
    float scale = 1.0f / max(chroma, 1e-20f);
    float sextants = 4.0f + scale * (rgb.x - rgb.y);
    sextants = most == rgb.y ? 2.0f + scale * (rgb.z - rgb.x) : sextants;
    sextants = most == rgb.x ? scale * (rgb.y - rgb.z) : sextants;
    return vec3(least, chroma, sextants < 0.0f ? sextants + 6.0f : sextants);
}

// D of light from a surface at `relative` from the eye (world axes, any length unit) that moves along the unit vector
// `along` with rapidity ln(exp_rapidity): 1 +- cos as sums of squares, so nothing cancels at any speed.
float wavelength_ratio_from(vec3 relative, vec3 along, float exp_rapidity) {
    vec3 n = normalize(relative);
    vec3 ahead = n + along;
    vec3 behind = n - along;
    return 4.0f / (dot(ahead, ahead) * exp_rapidity + dot(behind, behind) / exp_rapidity);
}

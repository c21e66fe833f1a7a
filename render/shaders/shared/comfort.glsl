// How much of the picture's light is left at a place `from_axis` (tangent of its angle from where the eye looks) while
// the picture is narrowed by `narrowing` in [0, 1]: all within a clear circle, none beyond a dark one, smooth between
// them. At 0 nothing within 58 degrees is touched, at 1 the clear circle reaches 14 degrees and the dark begins at 37.
// Also compiles as C++.
float vignette_light(float from_axis, float narrowing) {
    float clear = mix(1.6f, 0.25f, narrowing);
    float dark = mix(2.4f, 0.75f, narrowing);
    return 1.0f - smoothstep(clear, dark, from_axis);
}

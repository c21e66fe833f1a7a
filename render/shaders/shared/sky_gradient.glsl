// Radiance of the built-in sky seen in a unit world direction, by the direction's height `up` (its y component): from
// `horizon` up to `zenith` as the air thins, and from `horizon` down to the ground's `nadir` within a few degrees.
// Continuous, with a crease at the horizon only, as a real one has.
vec3 gradient_sky_radiance(float up, vec3 zenith, vec3 horizon, vec3 nadir) {
    float low = 1.0f - clamp(up, 0.0f, 1.0f);
    float above = 1.0f - low * low * low;
    float depth = clamp(-8.0f * up, 0.0f, 1.0f);
    float below = depth * (2.0f - depth);
    return up >= 0.0f ? mix(horizon, zenith, above) : mix(horizon, nadir, below);
}

// Mipmap level of the sky cube for one pixel: `texels_per_pixel` at the screen's centre where D = 1; aberration shows
// 1/D of the world's angle in an angle of the eye; `ray` is the pixel's eye ray, 1 at the screen's axis, and a pixel off
// the axis covers less. Also compiles as C++.
float sky_lod(float texels_per_pixel, float wavelength_ratio, vec3 ray) {
    return max(log2(texels_per_pixel / wavelength_ratio) - 0.75f * log2(dot(ray, ray)), 0.0f);
}

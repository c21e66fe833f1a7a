#version 450 core
// The last pass: exposed, through the tone curve, encoded; or the light's numbers in false colour, lines of equal
// value.
#include "shared/display.glsl"

in vec2 ndc;

layout(location = 0) uniform float exposure; // on top of what is baked into the light
layout(location = 1) uniform bool filmic_curve;
layout(location = 2) uniform vec2 corner; // of the viewport
layout(location = 3) uniform bool dither;
layout(location = 15) uniform float brightest; // share of the display's light

layout(binding = 0) uniform sampler2D light;

#ifdef BLOOM
#include "shared/bloom.glsl"
layout(location = 4) uniform float bloom_share;
layout(location = 5) uniform vec2 picture_size; // pixels
layout(binding = 1) uniform sampler2D bloom_cells;
#endif

#ifdef ANALYSIS
#include "shared/false_colour.glsl"
#include "shared/warp.glsl"
layout(location = 6) uniform vec3 ray_origin; // eye ray of the picture's lower left corner, axis frame
layout(location = 7) uniform vec3 ray_across; // its change over the picture
layout(location = 8) uniform vec3 ray_upwards;
layout(location = 9) uniform float exp_rapidity;
layout(location = 10) uniform int view; // render::View
layout(location = 11) uniform bool iso_lines;
layout(location = 12) uniform vec2 shift_scale;      // range and iso-line step of log2 D
layout(location = 13) uniform vec3 brightness_scale; // darkest and brightest stops on middle grey, iso-line step
layout(location = 14) uniform vec2 shown_pixel;      // 1 / size of the viewport
#endif

layout(location = 0) out vec4 colour;

vec3 exposed_at(vec2 place) {
    vec3 seen = textureLod(light, place, 0.0).rgb;
#ifdef BLOOM
    vec2 cells = vec2(textureSize(bloom_cells, 0));
    vec2 pixel = floor(place * picture_size);
    vec2 cell = vec2(bloom_place(pixel.x, cells.x / picture_size.x), bloom_place(pixel.y, cells.y / picture_size.y));
    seen = mix(seen, textureLod(bloom_cells, cell / cells, 0.0).rgb, bloom_share);
#endif
    return exposure * seen;
}

#ifdef ANALYSIS
float shift_at(vec2 place) {
    vec3 ray = ray_origin + place.x * ray_across + place.y * ray_upwards;
    return log2(see_along_z(normalize(ray), exp_rapidity).wavelength_ratio);
}

float stops_at(vec2 place) {
    return log2(max(luminance(exposed_at(place)), 1e-12) / 0.18);
}

vec3 analysed(vec2 place) {
    vec2 right = place + vec2(shown_pixel.x, 0.0);
    vec2 above = place + vec2(0.0, shown_pixel.y);
    if (view == 3) {
        float stops = stops_at(place);
        float share = (stops - brightness_scale.x) / (brightness_scale.y - brightness_scale.x);
        vec3 result = brightness_colour(share);
        if (iso_lines) {
            float change = length(vec2(stops_at(right), stops_at(above)) - vec2(stops));
            result = with_line(result, iso_line(stops, brightness_scale.z, change), false);
        }
        return result;
    }
    float shift = shift_at(place);
    float level = view == 2 ? band_middle(shift, shift_scale.y) : shift;
    vec3 result =
        view == 0 ? display_colour(exposed_at(place), filmic_curve, brightest, srgb_gamut()) : shift_colour(level, shift_scale.x);
    if (iso_lines) {
        float change = length(vec2(shift_at(right), shift_at(above)) - vec2(shift));
        result = with_line(result, iso_line(shift, shift_scale.y, change), view == 0);
    }
    return result;
}
#endif

void main() {
    vec2 place = 0.5 * ndc + 0.5;
#ifdef ANALYSIS
    vec3 encoded = analysed(place);
#else
    vec3 encoded = display_colour(exposed_at(place), filmic_curve, brightest, srgb_gamut());
#endif
    float threshold = dither ? dither_threshold(floor(gl_FragCoord.xy - corner)) : 0.5;
    colour = vec4(display_steps(encoded, threshold) / 255.0, 1.0);
}

// From linear light to what a display is given. Also compiles as C++.

// Linear RGB of some primaries seen by the cones of Oklab (Ottosson 2020), whose cube roots make lines of equal hue
// straight; luminance: weights of the components. White is (1, 1, 1) in both.
struct Gamut {
    mat3 cones_from_rgb;
    mat3 rgb_from_cones;
    vec3 luminance;
};

// Components as far below 0, relative to the largest, still count as inside and become 0. Lines of equal hue leave sRGB
// by 0.0008 and come back near its blue; without the slack, blue would jump to where its line leaves. Hues turn by less
// than a quarter of a degree for it.
const float gamut_slack = 0.001f;

float cube(float x) {
    return x * x * x;
}

// To single precision: a third of the exponent, and as much of the mantissa, is within 4 % of the root, and each of
// Halley's steps cubes that. What is below 1e-30 has the root 1e-10.
float cube_root(float x) {
    float size = max(abs(x), 1e-30f);
    float root = uintBitsToFloat(floatBitsToUint(size) / 3u + 0x2a5137a0u);
    float cubed = root * root * root;
    root = root * ((cubed + 2.0f * size) / (2.0f * cubed + size));
    cubed = root * root * root;
    root = root * ((cubed + 2.0f * size) / (2.0f * cubed + size));
    return x < 0.0f ? -root : root;
}

// A component below 0 or above `most`.
bool outside_gamut(vec3 rgb, float most) {
    float peak = max(max(rgb.x, rgb.y), rgb.z);
    return !(min(min(rgb.x, rgb.y), rgb.z) >= -gamut_slack * peak && peak <= most * (1.0f + gamut_slack));
}

// A colour's luminance, and the line of its hue and lightness from grey (saturation 0) to the colour (1): on it RGB is a
// cubic in the saturation, for cones are cubes of their roots, which change evenly.
struct HueLine {
    float grey;
    vec3 linear;
    vec3 quadratic;
    vec3 cubic;
    float luminance;
};

HueLine hue_line(vec3 rgb, Gamut gamut) {
    vec3 cones = gamut.cones_from_rgb * rgb;
    vec3 roots = vec3(cube_root(cones.x), cube_root(cones.y), cube_root(cones.z));
    float lightness = dot(roots, vec3(0.2104542553f, 0.7936177850f, -0.0040720468f));
    vec3 away = roots - vec3(lightness);
    return HueLine(cube(lightness), gamut.rgb_from_cones * (3.0f * lightness * lightness * away),
                   gamut.rgb_from_cones * (3.0f * lightness * away * away),
                   gamut.rgb_from_cones * (away * away * away), dot(rgb, gamut.luminance));
}

vec3 desaturated(HueLine line, float saturation) {
    return (vec3(line.grey) + saturation * line.linear) +
           (saturation * saturation) * (line.quadratic + saturation * line.cubic);
}

// From where on there is no limit to how bright a component may be.
const float unlimited = 1e30f;

// How far within the gamut that is, once it is scaled to the colour's luminance: below 0 outside.
float room_in_gamut(HueLine line, float saturation, float most, Gamut gamut) {
    vec3 tried = desaturated(line, saturation);
    float least = min(min(tried.x, tried.y), tried.z);
    float peak = max(max(tried.x, tried.y), tried.z);
    float above_black = least + gamut_slack * peak;
    float below_most = most * dot(tried, gamut.luminance) - peak * line.luminance;
    return most < unlimited ? min(above_black, below_most) : above_black;
}

// Between a saturation that fits and one `part` above it that does not, and the room there.
struct SaturationSearch {
    float fitting;
    float room_fitting;
    float room_above;
};

// Bisection by eight such parts, then a straight line between the last two: within 3e-5 of the largest saturation that
// fits for 99.9 % of colours, 1.5e-3 where another component begins to limit it.
const float first_part = 0.5f;
const float last_part = 1.0f / 256.0f;

SaturationSearch begin_search(HueLine line, float most, Gamut gamut) {
    return SaturationSearch(0.0f, room_in_gamut(line, 0.0f, most, gamut), room_in_gamut(line, 1.0f, most, gamut));
}

SaturationSearch halved(SaturationSearch search, float part, HueLine line, float most, Gamut gamut) {
    float tried = search.fitting + part;
    float room = room_in_gamut(line, tried, most, gamut);
    bool fits = room >= 0.0f;
    return SaturationSearch(fits ? tried : search.fitting, fits ? room : search.room_fitting,
                            fits ? search.room_above : room);
}

float found_saturation(SaturationSearch search) {
    float span = max(search.room_fitting - min(search.room_above, 0.0f), 1e-35f);
    return search.fitting + last_part * min(search.room_fitting / span, 1.0f);
}

// The line's colour of a saturation that fits. Light without luminance is black, what no saturation could show is
// white.
vec3 fitting_colour(HueLine line, float saturation, float most, Gamut gamut) {
    vec3 found = max(desaturated(line, saturation), 0.0f);
    vec3 scaled = found * (line.luminance / dot(found, gamut.luminance));
    vec3 lit = line.luminance > 0.0f && line.grey > 0.0f ? scaled : vec3(0.0f);
    return line.luminance < most ? lit : vec3(most);
}

// A colour outside the gamut (a component below 0 or above `most`) moves towards the grey of its own luminance on the
// line of its hue in Oklab, until it is inside: hue and luminance stay, saturation gives way. Scaled to the luminance
// afterwards, which changes no hue.
vec3 within_gamut(vec3 rgb, float most, Gamut gamut) {
    vec3 result = rgb;
    bool outside = outside_gamut(rgb, most);
    // At most once around: where no pixel is outside, software OpenGL skips a loop but not an if.
    while (outside) {
        outside = false;
        HueLine line = hue_line(rgb, gamut);
        SaturationSearch search = begin_search(line, most, gamut);
        for (float part = first_part; part >= last_part; part *= 0.5f) {
            search = halved(search, part, line, most, gamut);
        }
        result = fitting_colour(line, found_saturation(search), most, gamut);
    }
    return clamp(result, 0.0f, most);
}

const vec3 luminance_weights = vec3(0.2126f, 0.7152f, 0.0722f);

float luminance(vec3 rgb) {
    return dot(rgb, luminance_weights);
}

// Linear sRGB as Oklab's cones see it.
Gamut srgb_gamut() {
    return Gamut(mat3(0.41222147f, 0.21190350f, 0.08830246f, 0.53633254f, 0.68069955f, 0.28171884f, 0.05144599f,
                      0.10739696f, 0.62997870f),
                 mat3(4.07674166f, -1.26843800f, -0.00419609f, -3.30771159f, 2.60975740f, -0.70341861f, 0.23096993f,
                      -0.34131940f, 1.70761470f),
                 luminance_weights);
}

// Filmic shoulder on the largest component, so chromaticity stays: the identity up to 0.5, then a hyperbola that
// reaches 1 at infinity with the same slope at 0.5. What is squeezed loses saturation towards white, as film and the
// eye do.
vec3 filmic(vec3 rgb) {
    float peak = max(max(rgb.x, rgb.y), max(rgb.z, 1e-6f));
    float squeezed = peak > 0.5f ? 1.0f - 0.25f / peak : peak;
    float whitening = 1.0f - 1.0f / (1.0f + 0.12f * (peak - squeezed));
    vec3 scaled = rgb * (squeezed / peak);
    return scaled + whitening * (vec3(squeezed) - scaled);
}

// sRGB transfer function (IEC 61966-2-1), linear to encoded, clamped to [0, 1]. The power 1/2.4 is fitted by roots,
// which cost a third: within 3.5e-5, a hundredth of an 8-bit step.
vec3 srgb_encoded(vec3 linear) {
    vec3 x = clamp(linear, 0.0f, 1.0f);
    vec3 root = sqrt(x);
    vec3 fourth_root = sqrt(root);
    vec3 power = 1.1226675f * root + 0.1961438f * fourth_root - 0.3354939f * root * fourth_root + 0.0813302f * x;
    return mix(12.92f * x, power - 0.0646129f, greaterThan(x, vec3(0.0031308f)));
}

// Colour inside the gamut to encoded colour; with the filmic curve all above half of `brightest` is squeezed below it.
vec3 encoded_inside(vec3 inside, bool filmic_curve, float brightest) {
    vec3 curved = filmic_curve ? brightest * filmic(inside / brightest) : inside;
    return srgb_encoded(curved);
}

// Largest component that a colour may have before the curve.
float most_before_curve(bool filmic_curve, float brightest) {
    return filmic_curve ? unlimited : brightest;
}

// Exposed linear light to encoded colour. Filmic: any brightness is shown; else what is brighter than the display can
// be keeps its luminance and hue at the cost of saturation, up to white. No component becomes more than `brightest` of
// the display's light; with the filmic curve what is darker than half of it stays.
vec3 display_colour(vec3 exposed, bool filmic_curve, float brightest, Gamut gamut) {
    return encoded_inside(within_gamut(exposed, most_before_curve(filmic_curve, brightest), gamut), filmic_curve,
                          brightest);
}

// Whole steps of 1/255: with `threshold` in [0, 1) as often the step above as the value lies towards it. White stays
// white where 255 plus a threshold rounds to 256.
vec3 display_steps(vec3 encoded, float threshold) {
    return min(floor(255.0f * encoded + vec3(threshold)), 255.0f);
}

// Thresholds of neighbouring pixels spread evenly over [0, 1), in any stretch of them: the additive recurrence with the
// plastic number's reciprocals (Roberts 2018). `pixel`: whole numbers from the picture's lower left corner.
float dither_threshold(vec2 pixel) {
    return fract(dot(pixel, vec2(0.75487767f, 0.56984029f)));
}

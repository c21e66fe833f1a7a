#pragma once

#include "content/scene_desc.h"
#include "render/colour/doppler_colour.h"

#include <vector>

/// How bright and of what colour a star is, for the GL layer and the CPU alike. A star is a black body too far to have
/// a size: what reaches the eye is an irradiance, here in the scene's radiance unit times steradian, as linear RGB.
/// Spread over a pixel it becomes radiance by division by the pixel's solid angle.
namespace render {

/// Irradiance of a star of visual magnitude 0 at rest: with it the faintest that a naked eye sees (magnitude 6.5) show
/// as dark grey points on a black sky at exposure 1, 90 degrees over 1280 pixels. (A noon's white has radiance 1; on
/// that scale the truth is 8e-11: a night's eye is open 20 stops further.)
inline constexpr double light_of_magnitude_zero = 1e-4;

/// Exposed radiance below which no pixel shows: half of the first step of an 8-bit sRGB display, linear.
inline constexpr double faintest_star_shown = 0.5 / 255.0 / 12.92;

/// What is needed of a star, distance and motion apart: its light is
/// exp(ln_strength + ln Y(T_seen) + exponent * ln D) / distance^2 * rgb(T_seen), distances in light-years.
struct StarSource {
    double ln_strength = 0.0;    ///< of light_of_magnitude_zero 10^(-0.4 V) distance_from_origin^2 / Y(T)
    double ln_temperature = 0.0; ///< kelvin
};

StarSource star_source(const DopplerColour& colour, const content::Star& star);

/// What a mode does to stars. The light of a surface is changed as everywhere (nothing, D^-4, or spectrum D^-5 with or
/// without D^4); aberration makes its solid angle D^2 times as large: in full the flux is the black body's at T/D
/// times D^2, in total D^-2.
struct StarMode {
    double temperature_shift = 1.0; ///< T_seen = T / D^temperature_shift
    double exponent = 2.0;          ///< power of D besides the black body's
};

StarMode star_mode(Mode mode);

/// Colours of black bodies seen by the eye that is adapted to the scene's light, for a 1D texture, RGBA32F, linear,
/// clamped: adapted linear RGB at luminance 1 and ln Y (W sr^-1 m^-3 nm), over even steps of ln T.
struct BlackBodyTexels {
    static constexpr int samples = 2048;
    std::vector<float> texels;     ///< samples * 4
    float coordinate_scale = 0.0f; ///< texture coordinate = scale * ln T + offset
    float coordinate_offset = 0.0f;
};

BlackBodyTexels black_body_texels(const DopplerColour& colour);

/// The star's light at the eye, linear RGB, in double precision; distance in light-years.
glm::dvec3 star_light(const DopplerColour& colour, const StarSource& source, Mode mode, double distance,
                      double wavelength_ratio);

} // namespace render

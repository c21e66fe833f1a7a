#pragma once

#include "sim/lorentz.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace sim {
class ShipWorldLine;
} // namespace sim

namespace render {

/// Which parts of what an eye sees are shown.
enum class Mode : std::uint8_t {
    geometry,    ///< aberration only: colours and brightness as at rest
    doppler,     ///< and colours shifted, brightness as at rest (the D^-4 of the total radiance divided out)
    searchlight, ///< aberration and brightness D^-4, colours as at rest
    full,        ///< everything
};

/// What a picture shows instead of light; each is written as float EXR.
enum class Layer : std::uint8_t {
    light,
    doppler,   ///< D = lambda_observed / lambda_emitted
    direction, ///< world direction, unit vector (x, y, z)
    distance,  ///< scene metres from the eye, in the world frame at the eye's event; infinity for the sky
    object,    ///< index into SceneDesc::instances as a number, ships counted on from there; -1 for the sky
};

/// How radiance becomes a picture.
struct Exposure {
    bool automatic = false;
    float stops = 0.0f;       ///< log2 of the factor on radiance; compensation when automatic
    bool linear_curve = true; ///< false: filmic curve
};

/// What a shown picture tells of the light.
enum class View : std::uint8_t {
    natural,   ///< the light itself, exposed and through the curve
    doppler,   ///< D in false colour
    rings,     ///< D in false colour, quantised: one colour from each iso-line to the next
    luminance, ///< luminance in false colour, by stops
};

/// How a picture is shown, besides its exposure.
struct Display {
    View view = View::natural;
    bool iso_lines = false; ///< lines of equal D over the picture, or of equal luminance where that is the view
    float bloom = 0.0f;     ///< share of the light that the eye scatters around; in [0, 1)
    float brightest = 1.0f; ///< largest share of the display's light that a pixel of light is given; in (0, 1]
    bool dither = true;     ///< 8 bits: the fraction of a step decides how often the next step is shown
};

/// Depths are reversed floats, nearest_depth / z: 1 at this distance from the eye, metres, 0 infinitely far. So small
/// costs nothing.
inline constexpr double nearest_depth = 0.01;

/// One eye's view: where it is, how it moves, what its screen covers.
struct EyeView {
    glm::dvec3 position{0.0};                             ///< scene metres, world, at the eye's event
    sim::Lorentz<sim::World, sim::Head> world_from_head;  ///< motion and orientation
    double horizontal_field_of_view = 1.5707963267948966; ///< radians, in (0, pi); of this width around the eye's axis
    int width = 1280;                                     ///< pixels
    int height = 720;
    /// Where the eye's axis meets the screen, in pixels from its middle, x right and y up: elsewhere than in the middle
    /// on a headset, whose eyes see further outwards than past the nose.
    glm::dvec2 axis_from_middle{0.0};
};

struct ShipBody;

/// A ship on its world line, seen where its light left it.
struct MovingShip {
    std::shared_ptr<const ShipBody> body;
    std::shared_ptr<const sim::ShipWorldLine> world_line;
    double full_thrust = 1.0; ///< c per clock unit, along the ship: its flames are then as in the model; > 0
};

/// The ships of a picture; none costs nothing.
struct MovingShips {
    std::vector<MovingShip> ships;
    double world_time = 0.0;            ///< of the eye's event, clock units
    double metres_per_light_unit = 1.0; ///< scene metres in one light clock unit, > 0
};

/// Everything one picture needs besides the scene itself: the seam between engine and render.
struct RenderFrame {
    EyeView eye;
    Mode mode = Mode::full;
    Layer layer = Layer::light;
    Exposure exposure;
    Display display;
    bool keep_depth = false;               ///< for Renderer::copy_depth
    std::size_t pane = 0;                  ///< of a split picture: each adapts its own automatic exposure
    double seconds_since_last_frame = 0.0; ///< pilot's time, for smooth automatic exposure; 0: adapt at once
    double sharpness = 1.0;                ///< texels per pixel of the warp's tiles, in [0.25, 2] (dynamic resolution)
    double metres_per_light_year = 9460730472580800.0; ///< scene metres in a light-year, for the stars
    MovingShips moving;
};

/// A finished picture in memory: `channels` floats a pixel, rows from the top. Light: 3 channels of linear sRGB after
/// exposure, before the tone curve and sRGB encoding.
struct Picture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<float> values;
};

} // namespace render

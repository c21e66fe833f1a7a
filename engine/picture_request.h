#pragma once

#include "content/scenario.h"
#include "engine/option_values.h"
#include "engine/panes.h"
#include "render/picture_file.h"
#include "render/render_frame.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// Texels a pixel of the texture method's stills, light and data layers alike: edges are then within half a pixel of
/// where they belong (`rapidity bench pictures`). Live pictures have 1.
inline constexpr double still_sharpness = 1.5;

/// How a still picture is made.
enum class PictureMethod : std::uint8_t {
    automatic, ///< texture where there is graphics hardware, else ray
    texture,   ///< OpenGL: the world at rest in tiles, then one warp pass
    plain,     ///< OpenGL: straight to the screen, one sample a pixel; for an eye at rest only
    ray,       ///< CPU: rays in packets, the live picture where there is no graphics hardware; needs no OpenGL
    reference, ///< CPU: one ray a sample in double precision
};

inline constexpr NamedValues<render::Mode, 4> mode_names{{{"geometry", render::Mode::geometry},
                                                          {"doppler", render::Mode::doppler},
                                                          {"searchlight", render::Mode::searchlight},
                                                          {"full", render::Mode::full}}};
inline constexpr NamedValues<render::Layer, 5> layer_names{{{"light", render::Layer::light},
                                                            {"doppler", render::Layer::doppler},
                                                            {"direction", render::Layer::direction},
                                                            {"distance", render::Layer::distance},
                                                            {"object", render::Layer::object}}};
inline constexpr NamedValues<PictureMethod, 5> method_names{{{"automatic", PictureMethod::automatic},
                                                             {"texture", PictureMethod::texture},
                                                             {"ray", PictureMethod::ray},
                                                             {"plain", PictureMethod::plain},
                                                             {"reference", PictureMethod::reference}}};

inline constexpr NamedValues<render::View, 4> view_names{{{"natural", render::View::natural},
                                                          {"doppler", render::View::doppler},
                                                          {"rings", render::View::rings},
                                                          {"luminance", render::View::luminance}}};
inline constexpr NamedValues<render::Primaries, 2> primaries_names{
    {{"srgb", render::Primaries::srgb}, {"rec2020", render::Primaries::rec2020}}};

/// The options of `rapidity render` as they were typed; unset ones take the scenario's value or a default.
struct PictureOptions {
    std::string scenario;
    std::string output; ///< "": no picture is made
    std::optional<std::string> beta;
    std::optional<std::string> rapidity;
    std::optional<std::string> heading;
    std::optional<std::string> at;
    std::optional<std::string> look;
    std::optional<std::string> field_of_view;
    std::optional<std::string> size;
    std::optional<std::string> mode;
    std::optional<std::string> layer;
    std::optional<std::string> reflectance;
    std::optional<bool> microwave_background;
    std::optional<std::string> method;
    std::optional<std::string> samples;
    std::optional<std::string> exposure;
    std::optional<std::string> curve;
    std::optional<std::string> view;
    std::optional<std::string> split;
    std::optional<std::string> bloom;
    std::optional<std::string> primaries;
    bool iso_lines = false;
    bool no_dither = false;
    bool no_legend = false;
    bool cockpit = false;
};

/// One still picture, ready to be made.
struct PictureRequest {
    content::Scenario scenario;
    render::RenderFrame frame;
    PictureMethod method = PictureMethod::automatic;
    int samples_per_side = 4; ///< of ray and reference, in each pixel
    std::filesystem::path file;
    render::PictureFormat format = render::PictureFormat::png;
    render::Primaries primaries = render::Primaries::srgb;
    std::vector<Pane> panes; ///< one, or those of a split picture
    bool cockpit = false;    ///< the cabin over it
    bool legend = true;      ///< false colours explained and panes named in the picture
    sim::Rapidity rapidity;
    glm::dvec3 heading{0.0, 0.0, -1.0};
    glm::dvec3 look{0.0, 0.0, -1.0};
    double time = 0.0; ///< of the eye's event, seconds of the world's clock
};

/// Stops on radiance, or "auto"; the curve is left at its default. Throws sim::BadInput naming the option.
render::Exposure exposure_option(const std::string& option, const std::string& text);

/// Checks everything that was typed before any work is done. Throws sim::BadInput naming the option.
PictureRequest picture_request(const PictureOptions& options);

/// What every picture of a moving eye shows exactly, for the files' metadata.
inline constexpr std::string_view exact_effects =
    "aberration, light travel time (scenery at rest), Doppler factor, searchlight D^-4";

/// Adds what the eye of a picture is and sees: its motion, place, look (in the world's axes carried over by its boost)
/// and mode.
void add_eye_metadata(render::PictureMetadata& metadata, const render::RenderFrame& frame);

/// Adds how light became colours: curve, bloom, view, panes where there are several.
void add_display_metadata(render::PictureMetadata& metadata, const render::RenderFrame& frame,
                          const std::vector<Pane>& panes);

/// What the picture's file says about it: motion, event, method, and which effects are exact or approximate.
render::PictureMetadata picture_metadata(const PictureRequest& request);

} // namespace engine

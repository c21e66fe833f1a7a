#pragma once

#include "engine/cameras/camera_settings.h"
#include "engine/cockpit/comfort.h"
#include "engine/option_values.h"
#include "render/gl/renderer.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// How live pictures can be drawn.
inline constexpr NamedValues<render::Method, 3> live_method_names{
    {{"automatic", render::Method::automatic}, {"texture", render::Method::texture}, {"ray", render::Method::ray}}};

/// The method that a picture was drawn by, as its file says; the renderer's automatic one may be plain at rest.
inline std::string drawn_method_name(render::Method method) {
    return method == render::Method::plain ? "plain" : name_of(method, live_method_names);
}

/// What `rapidity fly` was asked for, checked.
struct FlyOptions {
    std::filesystem::path script;        ///< flight script (CSV); "": fly by hand, or the demonstration
    std::string to;                      ///< destination that the autopilot flies to from the start; "": none
    std::filesystem::path recording;     ///< "": a new file in the flights' folder
    std::filesystem::path replay;        ///< window: a recording to show again instead of flying; "": none
    std::optional<double> seconds;       ///< of the pilot's time; none: until the script ends or the pilot quits
    bool real_time = false;              ///< headless: as slowly as a pilot would fly it
    std::filesystem::path film;          ///< headless: mp4 to make; "": none
    std::filesystem::path stills;        ///< headless: folder for stills; "": none
    std::filesystem::path demonstration; ///< headless: folder for recording, film and stills; "": not one
    PictureSize size;                    ///< pixels of film and stills, points of the window
    double frames_per_second = 30.0;     ///< of the film
    bool instruments = true;             ///< drawn into the film
    bool cockpit = false;                ///< seat the pilot in the cabin
    ComfortSettings comfort;             ///< as the flight begins
    std::optional<double> demo;          ///< demonstration mode: idle seconds after which it begins anew
    bool vr = false;                     ///< in a headset, where there is one
    std::optional<PictureSize> eye_size; ///< headset: pixels of an eye's picture; none: what it recommends
    bool stage = false;                  ///< headset: stand on the floor of the room instead of sitting
    render::Method method = render::Method::automatic;
    CameraSettings camera;
    std::vector<std::filesystem::path> ghosts; ///< recordings that fly along
};

} // namespace engine

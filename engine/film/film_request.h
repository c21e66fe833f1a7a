#pragma once

#include "engine/cameras/camera_settings.h"
#include "engine/film_view.h"
#include "engine/picture_request.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace engine {

/// Whose time a film's frames are even in.
enum class FilmClock : std::uint8_t {
    ship, ///< of the ship, or of the eye that travels a path
    world,
};

/// How a film is made, whatever it shows.
struct FilmRequest {
    std::filesystem::path video;  ///< .mp4, .webm or .mov; "": none
    std::filesystem::path frames; ///< folder for its pictures; "": beside the video until that is complete
    PictureSize size;             ///< of the whole picture
    double frames_per_second = 30.0;
    std::optional<FilmClock> clock;           ///< none: a flight's ship, a path's world
    double speed = 1.0;                       ///< factor on the pace of the flight or the scenario
    std::optional<render::Mode> mode;         ///< none: everything
    std::optional<render::Exposure> exposure; ///< none: the scenario's
    PictureMethod method = PictureMethod::automatic;
    int samples_per_side = 2; ///< squared, samples of a pixel
    FilmView view;
    CameraSettings camera;                     ///< whose eyes a flight is seen by
    std::vector<std::filesystem::path> ghosts; ///< recordings that fly along
};

} // namespace engine

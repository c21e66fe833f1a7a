#pragma once

#include "content/scenario.h"
#include "engine/film/film_request.h"
#include "render/picture_file.h"
#include "render/render_frame.h"

#include <cstddef>
#include <functional>
#include <string>

namespace engine {

/// One frame of a film before it is drawn.
struct FilmShot {
    render::RenderFrame frame;        ///< of the whole picture; its eye is the middle of the head
    render::PictureMetadata metadata; ///< what the picture's file says beside how it was drawn and shown
};

/// What a film shows.
struct FilmReel {
    std::string description; ///< whole lines; two reels with the same show the same
    std::size_t frames = 0;
    std::function<FilmShot(std::size_t)> shot;
};

/// What makes a film what it is, a line for each: the reel's description, size, rate, mode, method. Two films with the
/// same lines are the same, byte for byte, on the same machine.
std::string film_description(const FilmReel& reel, const FilmRequest& request, PictureMethod method);

/// Makes the film. Automatic exposure adapts from frame to frame as an eye does in the film's time. Frames that an
/// interrupted run has left are kept, and the rest is made, to the same bytes. Throws sim::BadInput for what cannot be
/// written, and for a folder with the frames of another film; Failure when ffmpeg fails.
void make_film(const content::Scenario& scenario, const FilmReel& reel, const FilmRequest& request);

/// The settings of a film's pictures of a scenario.
PictureSettings film_settings(const content::Scenario& scenario, const FilmRequest& request);

} // namespace engine

#pragma once

#include "engine/film_view.h"
#include "engine/picture_request.h"
#include "engine/replay.h"
#include "engine/replay_deck.h"

#include <filesystem>
#include <optional>
#include <string>

namespace engine {

/// A film of a recorded flight.
struct ReplayFilmRequest {
    std::filesystem::path video;  ///< .mp4, .webm or .mov; "": none
    std::filesystem::path frames; ///< folder for its pictures; "": beside the video until that is complete
    PictureSize size;             ///< of the whole picture
    double frames_per_second = 30.0;
    bool by_world_clock = false; ///< frames are evenly spaced in the world's time, not the ship's
    double speed = 1.0;          ///< factor on the recorded pace
    render::Mode mode = render::Mode::full;
    PictureMethod method = PictureMethod::automatic;
    int samples_per_side = 2; ///< squared, samples of a pixel
    FilmView view;
};

/// Positions in ticks of a film's frames: the first at the flight's start, the others one frame's time apart.
std::vector<double> frame_positions(ReplayDeck& deck, const ReplayFilmRequest& request);

/// What makes a film what it is, a line for each: the recording's checksum, size, rate, mode, method. Two films with
/// the same lines are the same, byte for byte, on the same machine.
std::string film_description(const Recording& recording, const ReplayFilmRequest& request, PictureMethod method);

/// Makes the film. Frames that an interrupted run has left are kept, and the rest is made. Each frame is exposed on its
/// own. Throws sim::BadInput for what cannot be written, and for a folder with the frames of another film; Failure when
/// ffmpeg fails.
void make_replay_film(const Replay& replay, const ReplayFilmRequest& request);

} // namespace engine

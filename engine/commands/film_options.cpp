#include "engine/commands/film_options.h"

#include "sim/bad_input.h"

namespace engine {
namespace {

constexpr int largest_samples_per_side = 16;
constexpr double largest_eye_distance = 1e12; // giants fly among the stars
constexpr NamedValues<FilmClock, 2> clock_names{{{"ship", FilmClock::ship}, {"world", FilmClock::world}}};

void check_video(const std::string& video, const PictureSize& size) {
    const std::string extension = std::filesystem::path(video).extension().string();
    if (extension != ".mp4" && extension != ".webm" && extension != ".mov") {
        throw sim::BadInput("--video", "", video, "must end in .mp4, .webm or .mov");
    }
    if (size.width % 2 != 0 || size.height % 2 != 0) {
        throw sim::BadInput("--size", "", "", "a video's sides must be even; --frames may have any");
    }
}

} // namespace

void add_film_options(CLI::App& command, FilmOptions& options) {
    command.add_option("-o,--video", options.video, "film to make: .mp4, .webm or .mov (needs ffmpeg)");
    command.add_option("--frames", options.frames, "folder for the film's pictures; an interrupted film goes on there");
    command.add_option("--size", options.size, "WxH of the film's pictures (1280x720)");
    command.add_option("--fps", options.frames_per_second, "the film's frames a second (30)");
    command.add_option("--clock", options.clock,
                       "whose time the film's frames are even in: ship or world (ship; of a path world)");
    command.add_option("--speed", options.speed, "of the film: 0.01 to 1000 times the recorded pace (1)");
    command.add_option("--mode", options.mode, "of the film: geometry, doppler, searchlight or full (full)");
    command.add_option("--samples", options.samples, "samples along each side of a film's pixel (2)");
    command.add_option("--projection", options.projection,
                       "of the film: perspective, or equirectangular: all around the head (perspective)");
    command.add_option("--exposure", options.exposure, "of the film: stops on radiance, or auto (the scenario's)");
    command.add_option("--stereo", options.stereo, "scene metres between the eyes of a film side by side");
}

FilmRequest film_request(const FilmOptions& options, const std::string& method) {
    FilmRequest request;
    request.video = options.video;
    request.frames = options.frames;
    request.size = options.size ? size_option("--size", *options.size) : request.size;
    if (!options.video.empty()) {
        check_video(options.video, request.size);
    }
    if (options.frames_per_second) {
        request.frames_per_second = number_option("--fps", *options.frames_per_second, 0.1, 1000.0);
    }
    if (options.clock) {
        request.clock = named_option("--clock", *options.clock, clock_names);
    }
    request.speed = options.speed ? number_option("--speed", *options.speed, 0.01, 1000.0) : 1.0;
    if (options.mode) {
        request.mode = named_option("--mode", *options.mode, mode_names);
    }
    if (options.exposure) {
        request.exposure = exposure_option("--exposure", *options.exposure);
        request.exposure->linear_curve = false;
    }
    if (!method.empty()) {
        request.method = named_option("--method", method, method_names);
        if (request.method == PictureMethod::plain) {
            throw sim::BadInput("--method", "", method, "shows an eye at rest only");
        }
    }
    if (options.samples) {
        request.samples_per_side = whole_number_option("--samples", *options.samples, 1, largest_samples_per_side);
    }
    if (options.projection) {
        request.view.projection = named_option("--projection", *options.projection, projection_names);
    }
    if (options.stereo) {
        request.view.eye_distance = number_option("--stereo", *options.stereo, 0.0, largest_eye_distance);
        if (request.view.projection == FilmProjection::equirectangular) {
            throw sim::BadInput("--stereo", "", *options.stereo,
                                "is for a perspective: all around, eyes have no sides");
        }
        if (request.size.width % 2 != 0) {
            throw sim::BadInput("--size", "", *options.size, "two pictures side by side need an even width");
        }
    }
    return request;
}

} // namespace engine

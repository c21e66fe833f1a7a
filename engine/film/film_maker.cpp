#include "engine/film/film_maker.h"

#include "engine/failure.h"
#include "engine/film.h"
#include "engine/film/exposure_log.h"
#include "engine/fly/loaded_scene.h"
#include "engine/picture_maker.h"
#include "render/picture_file.h"
#include "render/shown_picture.h"
#include "sim/bad_input.h"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

namespace engine {
namespace {

constexpr const char* description_file = "film.txt";

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::filesystem::path frame_file(const std::filesystem::path& folder, std::size_t frame) {
    return folder / fmt::format("frame-{:06}.png", frame + 1);
}

/// Makes the folder this film's, or finds that it is already.
void claim_folder(const std::filesystem::path& folder, const std::string& description) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        throw sim::BadInput(folder.string(), "", "", "no folder: " + error.message());
    }
    const std::filesystem::path file = folder / description_file;
    if (std::filesystem::exists(file)) {
        if (text_of(file) != description) {
            throw sim::BadInput(folder.string(), "", "", "holds the frames of another film; name another folder");
        }
        return;
    }
    if (!std::filesystem::is_empty(folder)) {
        throw sim::BadInput(folder.string(), "", "", "is not empty and holds no frames of a film");
    }
    std::ofstream stream(file, std::ios::binary);
    stream << description;
    stream.close();
    if (!stream) {
        throw sim::BadInput(file.string(), "", "", "cannot be written");
    }
}

/// Says now and then how far the film is and how long it will take.
class Progress {
  public:
    Progress(std::size_t all, std::size_t there) : all_(all), there_(there) {}
    void frame_done(std::size_t frame) {
        ++made_;
        const auto now = std::chrono::steady_clock::now();
        if (now - told_ < std::chrono::seconds(2)) {
            return;
        }
        told_ = now;
        const std::chrono::duration<double> taken = now - start_;
        const double left = taken.count() / static_cast<double>(made_) * static_cast<double>(all_ - there_ - made_);
        fmt::print(stderr, "frame {} of {}, {:.0f} s left\n", frame + 1, all_, left);
    }

  private:
    std::size_t all_;
    std::size_t there_;
    std::size_t made_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point told_ = start_;
};

/// What a frame's file says beside what its shot knows.
render::PictureMetadata frame_metadata(const FilmShot& shot, const FilmRequest& request, PictureMethod method,
                                       double stops) {
    render::PictureMetadata metadata = shot.metadata;
    metadata["method"] = name_of(method, method_names);
    metadata["samples_per_pixel"] = static_cast<double>(request.samples_per_side * request.samples_per_side);
    metadata["projection"] = name_of(request.view.projection, projection_names);
    metadata["eye_distance_metres"] = request.view.eye_distance;
    metadata["exposure_stops"] = stops;
    add_eye_metadata(metadata, shot.frame);
    add_display_metadata(metadata, shot.frame, {});
    return metadata;
}

void make_frames(const FilmReel& reel, const FilmRequest& request, FrameMaker& maker,
                 const std::filesystem::path& folder) {
    std::size_t there = 0;
    for (std::size_t i = 0; i < reel.frames; ++i) {
        there += std::filesystem::exists(frame_file(folder, i)) ? 1 : 0;
    }
    if (there > 0) {
        fmt::print(stderr, "{} of {} frames are there already\n", there, reel.frames);
    }
    SequenceExposure exposure(folder / "exposure.csv", request.frames_per_second);
    Progress progress(reel.frames, there);
    for (std::size_t i = 0; i < reel.frames; ++i) {
        const std::filesystem::path file = frame_file(folder, i);
        const bool is_there = std::filesystem::exists(file);
        const FilmShot shot = reel.shot(i);
        render::Picture light;
        if (!is_there || exposure.needs(i, shot.frame.exposure)) {
            light = film_picture(maker, shot.frame, request.view);
        }
        const double stops = exposure.stops(i, shot.frame.exposure, light);
        if (!is_there) {
            render::write_png(file, render::shown_picture(light, shot.frame, stops),
                              frame_metadata(shot, request, maker.method(), stops));
            progress.frame_done(i);
        }
    }
}

} // namespace

PictureSettings film_settings(const content::Scenario& scenario, const FilmRequest& request) {
    PictureSettings picture = starting_picture(scenario);
    picture.width = request.size.width;
    picture.height = request.size.height;
    picture.mode = request.mode.value_or(render::Mode::full);
    picture.exposure = request.exposure.value_or(picture.exposure);
    picture.display.dither = false; // videos are coded: noise would cost, and not last
    return picture;
}

std::string film_description(const FilmReel& reel, const FilmRequest& request, PictureMethod method) {
    const std::string exposure =
        request.exposure
            ? fmt::format("{}{:+} stops", request.exposure->automatic ? "automatic " : "", request.exposure->stops)
            : "the scenario's";
    return fmt::format(
        "Rapidity {}: {}size {}x{}\nframes a second {}, speed {}\nmode {}, exposure {}\nmethod {}, {} samples a "
        "pixel\nprojection {}, eyes {} m apart\n",
        RAPIDITY_VERSION, reel.description, request.size.width, request.size.height, request.frames_per_second,
        request.speed, name_of(request.mode.value_or(render::Mode::full), mode_names), exposure,
        name_of(method, method_names), request.samples_per_side * request.samples_per_side,
        name_of(request.view.projection, projection_names), request.view.eye_distance);
}

void make_film(const content::Scenario& scenario, const FilmReel& reel, const FilmRequest& request) {
    if (!request.video.empty() && program_on_path("ffmpeg").empty()) {
        throw sim::BadInput("--video", "", request.video.string(),
                            "ffmpeg is not installed (Debian: apt-get install ffmpeg); --frames needs none");
    }
    const PictureMethod method = chosen_method(request.method);
    const std::string description = film_description(reel, request, method);
    const std::filesystem::path folder =
        request.frames.empty() ? std::filesystem::path(request.video.string() + ".frames") : request.frames;
    claim_folder(folder, description);
    const content::SceneDesc scene = loaded_scene(scenario);
    FrameMaker maker(scene, method, request.samples_per_side);
    make_frames(reel, request, maker, folder);
    if (!request.frames.empty()) {
        fmt::print("{}: {} frames\n", folder.string(), reel.frames);
    }
    if (!request.video.empty()) {
        const std::string trouble =
            encode_frames(folder / "frame-%06d.png", request.frames_per_second, description, request.video);
        if (!trouble.empty()) {
            throw Failure(trouble + "; the frames are kept in " + folder.string());
        }
        if (request.frames.empty()) {
            std::error_code ignored;
            std::filesystem::remove_all(folder, ignored);
        }
        fmt::print("{}: {} frames of {}x{}\n", request.video.string(), reel.frames, request.size.width,
                   request.size.height);
    }
}

} // namespace engine

#include "engine/replay_film.h"

#include "engine/failure.h"
#include "engine/film.h"
#include "engine/fly/loaded_scene.h"
#include "engine/picture_maker.h"
#include "render/picture_file.h"
#include "render/shown_picture.h"
#include "sim/bad_input.h"

#include <chrono>
#include <cmath>
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

/// Position in ticks, at or after `from`, at which the world's clock shows `time`.
double position_at_world_time(ReplayDeck& deck, double from, double time) {
    const auto clock_at = [&deck](double position) {
        deck.seek(position);
        const sim::VehicleState state = deck.state();
        return state.event.t + state.event_offset.t;
    };
    const auto end = static_cast<double>(deck.end());
    double low = from;
    double high = std::floor(from) + 1.0;
    for (double stride = 1.0; high < end && clock_at(high) < time; stride *= 2.0) {
        low = high;
        high = std::min(high + stride, end);
    }
    constexpr int halvings = 60; // down to a double's last digits
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (clock_at(middle) < time ? low : high) = middle;
    }
    return std::min(high, end);
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

void make_frames(const Replay& replay, const ReplayFilmRequest& request, FrameMaker& maker, ReplayDeck& deck,
                 const std::vector<double>& positions, const std::filesystem::path& folder) {
    Flight flight(replay.scenario, nullptr);
    PictureSettings picture = starting_picture(replay.scenario);
    picture.width = request.size.width;
    picture.height = request.size.height;
    picture.mode = request.mode;
    std::size_t there = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        there += std::filesystem::exists(frame_file(folder, i)) ? 1 : 0;
    }
    if (there > 0) {
        fmt::print(stderr, "{} of {} frames are there already\n", there, positions.size());
    }
    Progress progress(positions.size(), there);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::filesystem::path file = frame_file(folder, i);
        if (std::filesystem::exists(file)) {
            continue;
        }
        deck.seek(positions[i]);
        flight.show(deck.moment());
        const render::Picture radiance = film_picture(maker, flight, deck.moment(), picture, request.view);
        render::write_png(file, render::shown_picture(radiance, picture.exposure));
        progress.frame_done(i);
    }
}

} // namespace

std::vector<double> frame_positions(ReplayDeck& deck, const ReplayFilmRequest& request) {
    const double pace = deck.recording().header.pace * request.speed; // clock units a second
    const double tick_rate = deck.recording().changes.front().vehicle.tick_rate;
    std::vector<double> positions;
    const auto first = static_cast<double>(deck.first());
    const auto end = static_cast<double>(deck.end());
    deck.seek(first);
    const double start_time = deck.state().event.t;
    for (double position = first; position < end || positions.empty();) {
        positions.push_back(position);
        const double elapsed = static_cast<double>(positions.size()) * pace / request.frames_per_second;
        position = request.by_world_clock ? position_at_world_time(deck, position, start_time + elapsed)
                                          : first + elapsed * tick_rate;
    }
    return positions;
}

std::string film_description(const Recording& recording, const ReplayFilmRequest& request, PictureMethod method) {
    return fmt::format("Rapidity {}: film of {}\nscenario {}\nrecording {:016x}\nsize {}x{}\nframes a second {}, {} "
                       "clock, speed {}\nmode {}\nmethod {}, {} samples a pixel\nprojection {}, eyes {} m apart\n",
                       RAPIDITY_VERSION, recording.header.title, recording.header.scenario_name, recording.checksum(),
                       request.size.width, request.size.height, request.frames_per_second,
                       request.by_world_clock ? "world" : "ship", request.speed, name_of(request.mode, mode_names),
                       name_of(method, method_names), request.samples_per_side * request.samples_per_side,
                       request.view.projection == FilmProjection::equirectangular ? "equirectangular" : "perspective",
                       request.view.eye_distance);
}

void make_replay_film(const Replay& replay, const ReplayFilmRequest& request) {
    if (!request.video.empty() && program_on_path("ffmpeg").empty()) {
        throw sim::BadInput("--video", "", request.video.string(),
                            "ffmpeg is not installed (Debian: apt-get install ffmpeg); --frames needs none");
    }
    const PictureMethod method = chosen_method(request.method);
    const std::string description = film_description(replay.recording, request, method);
    const std::filesystem::path folder =
        request.frames.empty() ? std::filesystem::path(request.video.string() + ".frames") : request.frames;
    claim_folder(folder, description);
    const content::SceneDesc scene = loaded_scene(replay.scenario);
    ReplayDeck deck(replay.recording);
    const std::vector<double> positions = frame_positions(deck, request);
    FrameMaker maker(scene, method, request.samples_per_side);
    make_frames(replay, request, maker, deck, positions, folder);
    if (!request.frames.empty()) {
        fmt::print("{}: {} frames\n", folder.string(), positions.size());
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
        fmt::print("{}: {} frames of {}x{}\n", request.video.string(), positions.size(), request.size.width,
                   request.size.height);
    }
}

} // namespace engine

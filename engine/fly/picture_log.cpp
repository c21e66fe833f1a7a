#include "engine/fly/picture_log.h"

#include "engine/fly/flight_metadata.h"
#include "engine/fly/hud_reading.h"
#include "engine/fly/loaded_scene.h"
#include "engine/hud/instruments.h"
#include "render/picture_file.h"
#include "sim/bad_input.h"

#include <cstdio>
#include <fmt/core.h>
#include <system_error>
#include <utility>

namespace engine {
namespace {

/// The window height, in points, that the instruments are laid out for.
constexpr float layout_height = 720.0F;

/// Creates the folder; one line when that fails, else "".
std::string folder_trouble(const std::filesystem::path& folder) {
    std::error_code error;
    if (!folder.empty()) {
        std::filesystem::create_directories(folder, error);
    }
    return error ? fmt::format("{}: no folder: {}", folder.string(), error.message()) : "";
}

} // namespace

PictureLog::PictureLog(const content::Scenario& scenario, const FlyOptions& options, std::string name)
    : scenario_(scenario), stills_folder_(options.stills), name_(std::move(name)),
      frames_per_second_(options.frames_per_second), instruments_(options.instruments), navigation_(scenario),
      cameras_(scenario, options.camera, other_ships(scenario, options.ghosts)),
      renderer_(loaded_scene(scenario), {options.method}), screen_(options.size.width, options.size.height),
      picture_(starting_picture(scenario)) {
    picture_.width = options.size.width;
    picture_.height = options.size.height;
    if (!options.film.empty()) {
        if (const std::string trouble = folder_trouble(options.film.parent_path()); !trouble.empty()) {
            troubles_.push_back(trouble);
        } else {
            film_.emplace(options.film, picture_.width, picture_.height, frames_per_second_);
            hud_.emplace(nullptr, static_cast<float>(picture_.height) / layout_height);
        }
    }
    if (const std::string trouble = folder_trouble(stills_folder_); !trouble.empty()) {
        troubles_.push_back(trouble);
        stills_folder_.clear();
    }
}

void PictureLog::add(const Flight& flight, double fraction, bool still) {
    const bool filming = film_ && film_->trouble().empty();
    if (!filming && !still) {
        return;
    }
    const sim::VehicleState moment = flight.between(fraction);
    const glm::dquat head = flight.head_between(fraction);
    const double since_last = filming && film_pictures_ > 0 ? 1.0 / frames_per_second_ : 0.0;
    render::RenderFrame frame = build_frame(flight, moment, head, picture_, since_last);
    cameras_.apply(flight, moment, glm::dquat(1.0, 0.0, 0.0, 0.0), frame);
    const render::FrameStatistics statistics =
        renderer_.draw(frame, screen_.framebuffer(), {0, 0, picture_.width, picture_.height});
    if (still && !stills_folder_.empty()) {
        render::PictureMetadata metadata =
            flight_metadata(scenario_, flight, moment, frame, panes_of(picture_), statistics.exposure_stops);
        metadata["recording"] = name_;
        metadata["method"] = drawn_method_name(statistics.method);
        save_still(screen_.read(), metadata);
    }
    if (!filming) {
        return;
    }
    if (instruments_) {
        hud_->begin(picture_.width, picture_.height, 1.0 / frames_per_second_);
        HudModel model = read_instruments(scenario_, flight, moment, head, picture_, navigation_);
        model.panes.front().exposure_stops_used = statistics.exposure_stops;
        add_cameras(cameras_, flight, moment, frame, model);
        draw_instruments(model, *hud_);
        hud_->end(screen_.framebuffer(), picture_.width, picture_.height);
    }
    film_->add(screen_.read());
    ++film_pictures_;
}

void PictureLog::save_still(const content::Image& picture, const render::PictureMetadata& metadata) {
    const std::filesystem::path file = stills_folder_ / fmt::format("{}-{}.png", name_, stills_ + 1);
    try {
        render::write_png(file, picture, metadata);
        ++stills_;
        fmt::print("still: {}\n", file.string());
        std::fflush(stdout); // the next takes a while
    } catch (const sim::BadInput& error) {
        troubles_.emplace_back(error.what());
        stills_folder_.clear(); // the next would fail as well
    }
}

std::vector<std::string> PictureLog::finish() {
    std::vector<std::string> lines;
    if (film_) {
        if (film_->finish()) {
            lines.push_back(fmt::format("film: {} ({} pictures of {}x{}, {:g} a second)", film_->file().string(),
                                        film_pictures_, picture_.width, picture_.height, frames_per_second_));
        } else {
            lines.push_back(film_->trouble());
        }
    }
    lines.insert(lines.end(), troubles_.begin(), troubles_.end());
    return lines;
}

} // namespace engine

#include "engine/replay_film.h"

#include "engine/cameras/cameras.h"
#include "engine/fly/flight_metadata.h"

#include <cmath>
#include <fmt/format.h>
#include <memory>

namespace engine {
namespace {

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

/// A replay, where its frames are, and the flight that shows one of them.
class ReplayShots {
  public:
    ReplayShots(const Replay& replay, const FilmRequest& request)
        : scenario_(replay.scenario), deck_(replay.recording), checksum_(replay.recording.checksum()),
          positions_(frame_positions(deck_, request)), flight_(replay.scenario, nullptr),
          picture_(film_settings(replay.scenario, request)),
          cameras_(replay.scenario, request.camera, other_ships(replay.scenario, request.ghosts)) {
        if (!cameras_.idle()) {
            flight_.show_world_line(std::make_shared<const sim::ShipWorldLine>(deck_.world_line()));
        }
    }

    std::size_t frames() const { return positions_.size(); }

    FilmShot shot(std::size_t index) {
        deck_.seek(positions_.at(index));
        const FlightMoment& moment = deck_.moment();
        flight_.show(moment);
        FilmShot shot;
        shot.frame = build_frame(flight_, moment.between(), moment.head(), picture_, 0.0);
        cameras_.apply(flight_, moment.between(), glm::dquat(1.0, 0.0, 0.0, 0.0), shot.frame);
        shot.metadata = flight_metadata(scenario_, flight_, moment.between(), shot.frame, {}, 0.0);
        shot.metadata["recording"] = fmt::format("{:016x}", checksum_);
        return shot;
    }

  private:
    content::Scenario scenario_;
    ReplayDeck deck_;
    std::uint64_t checksum_;
    std::vector<double> positions_;
    Flight flight_;
    PictureSettings picture_;
    Cameras cameras_;
};

/// A line for what others than the pilot's eyes see, or see of others; none for most films.
std::string camera_lines(const FilmRequest& request) {
    const CameraSettings& camera = request.camera;
    std::string lines;
    if (camera.kind != CameraKind::pilot) {
        const auto text = [](const std::optional<glm::dvec3>& v) {
            return v ? fmt::format("{},{},{}", v->x, v->y, v->z) : std::string("default");
        };
        lines += fmt::format("camera {}, at {}, velocity {}, look {}\n", name_of(camera.kind, camera_names),
                             text(camera.place), text(camera.velocity), text(camera.look));
    }
    for (const std::filesystem::path& ghost : request.ghosts) {
        lines += fmt::format("ghost {:016x}\n", read_sound_recording(ghost).checksum());
    }
    return lines;
}

} // namespace

std::vector<double> frame_positions(ReplayDeck& deck, const FilmRequest& request) {
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
        position = request.clock == FilmClock::world ? position_at_world_time(deck, position, start_time + elapsed)
                                                     : first + elapsed * tick_rate;
    }
    return positions;
}

FilmReel replay_reel(const Replay& replay, const FilmRequest& request) {
    const auto shots = std::make_shared<ReplayShots>(replay, request);
    const RecordingHeader& header = replay.recording.header;
    return {fmt::format("film of {}\nscenario {}\nrecording {:016x}\n{} clock\n{}", header.title, header.scenario_name,
                        replay.recording.checksum(), request.clock == FilmClock::world ? "world" : "ship",
                        camera_lines(request)),
            shots->frames(), [shots](std::size_t index) { return shots->shot(index); }};
}

} // namespace engine

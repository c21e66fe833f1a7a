#include "engine/film/path_reel.h"

#include "engine/checksum.h"
#include "engine/film/path_camera.h"
#include "sim/bad_input.h"

#include <fmt/format.h>

namespace engine {
namespace {

std::uint64_t checksum_of(const content::CameraPath& path) {
    Checksum sum;
    sum.add(std::string_view(path.text));
    return sum.sum();
}

/// World times of the frames: the first at the path's start, the others one frame's time apart by its clock.
std::vector<double> frame_times(const PathCamera& camera, FilmClock clock, double step) {
    std::vector<double> times;
    for (double time = camera.first(); time < camera.last() || times.empty();) {
        times.push_back(time);
        const double elapsed = static_cast<double>(times.size()) * step;
        time = clock == FilmClock::world ? camera.first() + elapsed : camera.world_time(sim::ProperTime(elapsed));
    }
    return times;
}

void refuse_contradictions(const content::CameraPath& path, const PathCamera& camera, const FilmRequest& request) {
    if (request.mode && camera.has_modes()) {
        throw sim::BadInput("--mode", "", name_of(*request.mode, mode_names),
                            path.file.string() + " has modes of its own");
    }
    if (request.clock == FilmClock::ship && !camera.travels()) {
        throw sim::BadInput("--clock", "", "ship",
                            "observers with velocities of their own, as in " + path.file.string() +
                                ", have no clock in common; use world");
    }
}

render::RenderFrame frame_of(const content::Scenario& scenario, const PathCamera::Pose& pose,
                             const PictureSettings& picture) {
    render::RenderFrame frame;
    frame.eye.position = pose.position;
    frame.eye.world_from_head = pose.world_from_head;
    frame.eye.horizontal_field_of_view = pose.horizontal_field_of_view;
    frame.eye.width = picture.width;
    frame.eye.height = picture.height;
    frame.mode = pose.mode.value_or(picture.mode);
    frame.exposure = picture.exposure;
    frame.display = picture.display;
    frame.metres_per_light_year = scenario.speed_of_light * content::julian_year_seconds;
    return frame;
}

} // namespace

FilmReel path_reel(const content::Scenario& scenario, const content::CameraPath& path, const FilmRequest& request) {
    const PathCamera camera(path, scenario.metres_per_light_unit());
    refuse_contradictions(path, camera, request);
    const FilmClock clock = request.clock.value_or(FilmClock::world);
    const PictureSettings picture = film_settings(scenario, request);
    std::vector<FilmShot> shots;
    for (const double time : frame_times(camera, clock, scenario.pace * request.speed / request.frames_per_second)) {
        const PathCamera::Pose pose = camera.at(time);
        FilmShot shot{frame_of(scenario, pose, picture), {}};
        shot.metadata["scenario"] = scenario.name;
        shot.metadata["camera_path"] = path.file.filename().string();
        shot.metadata["event_time_seconds"] = scenario.clock_unit_seconds * time;
        if (camera.travels()) {
            shot.metadata["eye_clock_seconds"] = scenario.clock_unit_seconds * camera.proper_time(time).value;
        }
        shots.push_back(std::move(shot));
    }
    const std::size_t frames = shots.size();
    return {fmt::format("film of {}\nscenario {}\ncamera path {:016x}\n{} clock\n", scenario.title, scenario.name,
                        checksum_of(path), clock == FilmClock::world ? "world" : "ship"),
            frames, [shots = std::move(shots)](std::size_t index) { return shots.at(index); }};
}

} // namespace engine

#include "engine/fly/headless.h"

#include "engine/fixed_step.h"
#include "engine/flight_file.h"
#include "engine/fly/course.h"
#include "engine/fly/flight_summary.h"
#include "engine/fly/picture_log.h"
#include "engine/fly/recorded_flight.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/core.h>
#include <memory>
#include <thread>

namespace engine {
namespace {

constexpr int stills_of_a_flight = 8;

/// Sleeps until the pictures' clock and the wall's agree.
class RealTime {
  public:
    void wait_until(double seconds) const {
        std::this_thread::sleep_until(start_ + std::chrono::duration<double>(seconds));
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

void fly_headless(const content::Scenario& scenario, FlyOptions options) {
    const Course course = course_of(scenario, options);
    const std::filesystem::path folder = options.demonstration.empty() ? flights_folder() : options.demonstration;
    if (options.recording.empty()) {
        options.recording = new_flight_file(scenario.name, folder);
    }
    if (!options.demonstration.empty()) {
        options.film = folder / options.recording.stem().concat(".mp4");
        options.stills = folder;
    }
    if ((options.camera.kind != CameraKind::pilot || !options.ghosts.empty()) && options.film.empty() &&
        options.stills.empty()) {
        throw sim::BadInput("fly", "", "", "headless, cameras and ghosts need --film or --stills to be seen in");
    }
    RecordedFlight recorded(scenario, options.recording);
    Flight& flight = recorded.flight();
    flight.keep_world_line();
    if (course.target) {
        flight.set_target(course.target->object, course.target->name);
    }
    input::Pilot& pilot = *course.pilot;
    const double duration = course.duration;

    std::optional<PictureLog> pictures;
    if (!options.film.empty() || !options.stills.empty()) {
        pictures.emplace(scenario, options, options.recording.stem().string());
    }

    const double frame_seconds = 1.0 / options.frames_per_second;
    FixedStep clock(scenario.vehicle.tick_rate, frame_seconds);
    clock.set_pace(scenario.pace);
    const RealTime real_time;
    const auto frames = static_cast<std::int64_t>(std::ceil(duration / scenario.pace * options.frames_per_second));
    if (pictures) {
        fmt::print("flying {}: {} pictures of {}x{} to draw\n", scenario.name,
                   options.film.empty() ? stills_of_a_flight : frames, options.size.width, options.size.height);
        std::fflush(stdout); // it takes a while
    }
    std::int64_t stills_taken = 0;
    for (std::int64_t frame = 0; frame < frames && flight.stop().empty(); ++frame) {
        const FixedStep::Steps steps = clock.advance(frame_seconds);
        fly_ticks(flight, pilot, steps.ticks);
        if (pictures) {
            // The moments that cut the flight into equal parts, the last at its end.
            const bool still = (frame + 1) * stills_of_a_flight >= (stills_taken + 1) * frames;
            stills_taken += still ? 1 : 0;
            pictures->add(flight, steps.fraction, still);
        }
        if (options.real_time) {
            real_time.wait_until(static_cast<double>(frame + 1) * frame_seconds);
        }
    }
    // The last frame may have left part of the last tick.
    fly_to_the_end(flight, course);

    print_flight(scenario, flight);
    if (pictures) {
        for (const std::string& line : pictures->finish()) {
            fmt::print("{}\n", line);
        }
    }
    const std::string trouble = recorded.close();
    fmt::print("{}\n", trouble.empty() ? fmt::format("recording: {}", recorded.file().string()) : trouble);
    if (!flight.stop().empty()) {
        std::fflush(stdout); // what was flown is told first
        throw sim::BadInput(options.script.empty() ? scenario.name : options.script.string(), "", "", flight.stop());
    }
}

} // namespace engine

#include "engine/commands/camera_options.h"
#include "engine/commands/commands.h"
#include "engine/commands/film_options.h"

#include "content/camera_path.h"
#include "engine/failure.h"
#include "engine/film/path_reel.h"
#include "engine/fly/course.h"
#include "engine/fly/recorded_flight.h"
#include "engine/option_values.h"
#include "engine/replay.h"
#include "engine/replay_film.h"
#include "engine/temporary_folder.h"
#include "sim/bad_input.h"

#include <fmt/core.h>

#include <memory>
#include <string>

namespace engine {
namespace {

struct FilmCommand {
    std::string scenario;
    std::string all;  ///< folder for films of all built-in scenarios; "": one film
    std::string path; ///< camera path (TOML); "": a flight
    bool path_keys = false;
    std::string method;
    std::string seconds;
    FlyOptions fly;
    FilmOptions film;
    CameraOptions camera;
};

/// Flies and films it. The flight needs no keeping: the same course is the same flight, bit for bit.
void film_flight(const content::Scenario& scenario, const FlyOptions& options, const FilmRequest& request) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "flight.rapidity";
    const Course course = course_of(scenario, options);
    RecordedFlight recorded(scenario, file);
    if (course.target) {
        recorded.flight().set_target(course.target->object, course.target->name);
    }
    fly_to_the_end(recorded.flight(), course);
    if (const std::string trouble = recorded.close(); !trouble.empty()) {
        throw Failure(trouble);
    }
    Replay replay = load_replay(file);
    replay.recording.header.started.clear(); // flown again, an interrupted film's flight is the same one
    make_film(replay.scenario, replay_reel(replay, request), request);
    if (const std::string& stop = recorded.flight().stop(); !stop.empty()) {
        throw sim::BadInput(options.script.empty() ? scenario.name : options.script.string(), "", "", stop);
    }
}

void film_all(const FilmCommand& command) {
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        FilmOptions options = command.film;
        options.video = (std::filesystem::path(command.all) / (scenario.name + ".mp4")).string();
        film_flight(scenario, command.fly, film_request(options, command.method));
    }
}

void check_company(const FilmCommand& command) {
    const bool flies = !command.fly.script.empty() || !command.fly.to.empty() || command.fly.seconds;
    if (!command.path.empty() && flies) {
        throw sim::BadInput("--path", "", command.path, "nobody flies along a path: without --script, --to, --seconds");
    }
    if (!command.all.empty()) {
        if (!command.scenario.empty() || !command.path.empty() || flies || command.film.wanted() ||
            command.camera.any()) {
            throw sim::BadInput("--all", "", command.all,
                                "films the demonstrations of all scenarios: without a scenario, a path, a flight and "
                                "files of a film");
        }
        return;
    }
    if (!command.path.empty() && command.camera.any()) {
        throw sim::BadInput("--path", "", command.path, "is a camera itself: without --camera and --ghost");
    }
    if (command.scenario.empty()) {
        throw sim::BadInput("film", "", "", "name a scenario, or --all DIR");
    }
    if (!command.film.wanted()) {
        throw sim::BadInput("film", "", "", "needs -o FILE.mp4 (or .webm, .mov), --frames DIR or both");
    }
}

void make(FilmCommand command) {
    if (command.path_keys) {
        for (const std::string& line : content::camera_path_keys()) {
            fmt::print("{}\n", line);
        }
        return;
    }
    check_course(command.fly, command.seconds);
    check_company(command);
    if (!command.all.empty()) {
        film_all(command);
        return;
    }
    FilmRequest request = film_request(command.film, command.method);
    request.camera = camera_settings(command.camera);
    request.ghosts = command.camera.ghosts;
    const content::Scenario scenario = content::load_scenario(command.scenario);
    if (command.path.empty()) {
        film_flight(scenario, command.fly, request);
    } else {
        make_film(scenario, path_reel(scenario, content::read_camera_path(command.path, scenario), request), request);
    }
}

} // namespace

void add_film_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("film", "a film of a scenario: flown, or along a camera's path");
    command->group("Pictures");
    const auto options = std::make_shared<FilmCommand>();
    command->add_option("scenario", options->scenario, "name, .toml or bare .glb/.gltf");
    command->add_option("--all", options->all, "folder for films of the demonstrations of all built-in scenarios");
    command->add_option("--path", options->path, "keyframes of a camera (TOML) for a film that nobody flies");
    command->add_flag("--path-keys", options->path_keys, "print what a camera's path may say: every key and its unit");
    command->add_option("--script", options->fly.script, "flight script (CSV) to fly (the scenario's demonstration)");
    command->add_option("--to", options->fly.to,
                        "the autopilot flies there: a beacon or a star, by name or HIP number");
    command->add_option("--seconds", options->seconds, "end after this many seconds of the pilot's time");
    command->add_option("--method", options->method,
                        "how it is drawn: automatic, texture, ray or reference (automatic: ray without a GPU)");
    add_film_options(*command, options->film);
    add_camera_options(*command, options->camera);
    command->callback([options] { make(*options); });
}

} // namespace engine

#include "engine/commands/commands.h"
#include "engine/ranks/rank_link.h"
#include "engine/trace/trace_pictures.h"
#include "engine/trace/trace_request.h"
#include "sim/bad_input.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <fmt/core.h>
#include <memory>
#include <thread>

namespace engine {
namespace {

void list_scenarios() {
    for (const content::TracedScenario& scenario : content::built_in_traced_scenarios()) {
        fmt::print("{:<18} {}\n", scenario.name, scenario.title);
    }
}

void trace(const TraceOptions& options) {
    const std::unique_ptr<RankLink> link = open_rank_link();
    try {
        trace_pictures(trace_request(options), link.get());
    } catch (const std::exception& error) {
        if (link != nullptr && link->count() > 1) {
            if (link->rank() > 0) {
                // What troubles every rank alike is for rank 0 to say.
                std::this_thread::sleep_for(std::chrono::seconds(1));
            }
            fmt::print(stderr, "rapidity: {}\n", error.what());
            link->abort(); // the others would wait for ever
        }
        throw;
    }
}

} // namespace

void add_trace_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("trace", "pictures of curved spacetimes, on any number of cores and "
                                                            "machines (mpirun)");
    command->group("Pictures");
    const auto options = std::make_shared<TraceOptions>();
    const auto list = std::make_shared<bool>(false);
    const auto keys = std::make_shared<bool>(false);
    command->add_option("scenario", options->scenario, "a name (--list) or a .toml");
    command->add_option("-o,--output", options->output,
                        "the picture: .png for display, .exr for linear radiance and all layers; with #### for the "
                        "number of a sequence's frames");
    command->add_flag("--list", *list, "list the scenarios that come with the program");
    command->add_flag("--keys", *keys, "print what a scenario's TOML may say: every key, its unit, range and default");
    command->add_option("--param", options->parameters, "NAME=NUMBER, a parameter of the spacetime; may be repeated")
        ->take_all();
    command->add_option("--error", options->error, "error wanted, radians, in [1e-12, 1e-2] (1e-4)");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (1280x720; the whole sky 2048x1024)");
    command->add_option("--samples", options->samples,
                        "rays along each side of a pixel, 2 to 16 (2); up to 4 times as many at edges");
    command->add_option("--projection", options->projection,
                        "perspective, fisheye or equirectangular (all of the sky)");
    command->add_option("--fov", options->field_of_view, "field of view across the picture, degrees");
    command->add_option("--position", options->position, "of the camera, chart: x,y,z");
    command->add_option("--look", options->look, "direction of the view, chart axes: x,y,z");
    command->add_option("--at", options->at, "moment of the camera's path");
    command->add_option("--frames", options->frames, "pictures of a sequence along the camera's path or a recording");
    command->add_option("--recording", options->recording, "a recorded flight as the camera's path");
    command->add_option("--fps", options->frames_per_second,
                        "frames a second at which a sequence is to be shown: automatic exposure adapts so fast (30)");
    command->add_option("--exposure", options->exposure, "stops on radiance, or auto");
    command->add_option("--curve", options->curve, "linear or filmic (filmic)");
    command->add_option("--threads", options->threads, "at work in this process (all cores)");
    command->add_flag("--every-ray", options->every_ray, "trace every ray, also where a table of one dimension serves");
    command->add_flag("--restart", options->restart, "throw away the tiles that an interrupted run left");
    command->callback([options, list, keys] {
        if (*list) {
            list_scenarios();
        } else if (*keys) {
            for (const std::string& key : content::traced_scenario_keys()) {
                fmt::print("{}\n", key);
            }
        } else if (options->scenario.empty() || options->output.empty()) {
            throw sim::BadInput("trace", "", "", "give a scenario and -o FILE.png or .exr; --list lists scenarios");
        } else {
            trace(*options);
        }
    });
}

} // namespace engine

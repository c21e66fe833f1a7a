#include "engine/commands/commands.h"
#include "engine/picture_maker.h"
#include "engine/picture_request.h"
#include "render/shown_picture.h"

#include <cstdio>
#include <fmt/core.h>
#include <memory>

namespace engine {
namespace {

void render_picture(const PictureOptions& options) {
    PictureRequest request = picture_request(options);
    request.method = chosen_method(request.method);
    const content::SceneDesc scene = content::load_scene(request.scenario);
    for (const std::string& note : scene.notes) {
        fmt::print(stderr, "rapidity: note: {}\n", note);
    }
    const render::Picture picture = make_picture(scene, request);
    if (request.format == render::PictureFormat::exr) {
        render::write_exr(request.file, picture, picture_metadata(request));
    } else {
        render::write_png(request.file, render::shown_picture(picture, request.frame.exposure));
    }
    fmt::print("{}: {} x {} pixels, {}\n", request.file.string(), picture.width, picture.height,
               name_of(request.method, method_names));
}

} // namespace

void add_render_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("render", "one picture of a scenario as a moving eye sees it");
    command->group("Pictures");
    const auto options = std::make_shared<PictureOptions>();
    command->add_option("scenario", options->scenario, "a name, a .toml, or a .glb or .gltf")->required();
    command->add_option("-o,--output", options->output, "the picture: .png for display, .exr for linear radiance")
        ->required();
    command->add_option("--beta", options->beta, "speed as a fraction of the speed of light, in [0, 1)");
    command->add_option("--rapidity", options->rapidity, "speed as a rapidity, atanh(beta), in [0, 30]");
    command->add_option("--heading", options->heading, "direction of motion in the world: x,y,z");
    command->add_option("--at", options->at, "the eye's event in the world: t,x,y,z in seconds and scene metres");
    command->add_option("--look", options->look,
                        "direction of the view, x,y,z in the world's axes boosted along the heading");
    command->add_option("--fov", options->field_of_view, "horizontal field of view, degrees");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (1280x720)");
    command->add_option("--mode", options->mode, "geometry, doppler, searchlight or full (full)");
    command->add_option("--layer", options->layer, "light, doppler, direction, distance or object (light)");
    command->add_option("--method", options->method,
                        "automatic, texture, ray, plain or reference (automatic: ray without a GPU)");
    command->add_option("--samples", options->samples, "rays along each side of a pixel, for ray and reference (4)");
    command->add_option("--exposure", options->exposure, "stops on radiance, or auto");
    command->add_option("--curve", options->curve, "linear or filmic (filmic)");
    command->callback([options] { render_picture(*options); });
}

} // namespace engine

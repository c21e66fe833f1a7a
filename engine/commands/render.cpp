#include "engine/commands/commands.h"
#include "engine/commands/eye_options.h"
#include "engine/picture_maker.h"
#include "engine/picture_request.h"
#include "engine/still.h"
#include "render/shown_picture.h"

#include <cstdio>
#include <fmt/core.h>
#include <memory>
#include <utility>

namespace engine {
namespace {

void render_picture(const PictureOptions& options) {
    PictureRequest request = picture_request(options);
    request.method = chosen_method(request.method);
    const content::SceneDesc scene = content::load_scene(request.scenario);
    for (const std::string& note : scene.notes) {
        fmt::print(stderr, "rapidity: note: {}\n", note);
    }
    if (request.format == render::PictureFormat::exr) {
        render::Picture picture = make_picture(scene, request);
        if (request.frame.layer == render::Layer::light) {
            picture = render::in_primaries(std::move(picture), request.primaries);
            render::write_exr(request.file, picture, picture_metadata(request), request.primaries);
        } else {
            render::write_exr(request.file, picture, picture_metadata(request));
        }
    } else {
        render::write_png(request.file, make_still(scene, request), picture_metadata(request), request.primaries);
    }
    fmt::print("{}: {} x {} pixels, {}\n", request.file.string(), request.frame.eye.width, request.frame.eye.height,
               name_of(request.method, method_names));
}

} // namespace

void add_render_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("render", "one picture of a scenario as a moving eye sees it");
    command->group("Pictures");
    const auto options = std::make_shared<PictureOptions>();
    add_eye_options(*command, *options);
    command->add_option("-o,--output", options->output, "the picture: .png for display, .exr for linear radiance")
        ->required();
    command->add_option("--mode", options->mode, "geometry, doppler, searchlight or full (full)");
    command->add_option("--layer", options->layer, "light, doppler, direction, distance or object (light)");
    command->add_option("--reflectance", options->reflectance,
                        "spectra of RGB reflectances: five-terms, three-primaries or dominant-wavelength");
    add_microwave_options(*command, options->microwave_background);
    command->add_option("--method", options->method,
                        "automatic, texture, ray, plain or reference (automatic: ray without a GPU)");
    command->add_option("--samples", options->samples, "rays along each side of a pixel, for ray and reference (4)");
    command->add_option("--exposure", options->exposure, "stops on radiance, or auto");
    command->add_option("--curve", options->curve, "linear or filmic (filmic)");
    command->add_option("--view", options->view,
                        "natural, or in false colour: doppler, rings (quantised) or luminance (natural)");
    command->add_flag("--iso-lines", options->iso_lines, "lines of equal D; of equal luminance in its view");
    command->add_option("--split", options->split,
                        "two to four panes: modes, or views (D, rings, luminance), for example geometry,full,D");
    command->add_option("--bloom", options->bloom, "share of the light that the eye scatters around, 0 to 0.9 (0)");
    command->add_option("--primaries", options->primaries, "srgb or rec2020 (srgb)");
    command->add_flag("--no-dither", options->no_dither, "round every pixel to its nearest step");
    command->add_flag("--no-legend", options->no_legend, "false colours without their legend, panes without names");
    command->add_flag("--cockpit", options->cockpit, "the cabin around the eye, lit by what is seen around it");
    command->callback([options] { render_picture(*options); });
}

} // namespace engine

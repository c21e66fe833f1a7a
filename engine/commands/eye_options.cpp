#include "engine/commands/eye_options.h"

namespace engine {

void add_eye_options(CLI::App& command, PictureOptions& options) {
    command.add_option("scenario", options.scenario, "a name, a .toml, or a .glb or .gltf")->required();
    command.add_option("--beta", options.beta, "speed as a fraction of the speed of light, in [0, 1)");
    command.add_option("--rapidity", options.rapidity, "speed as a rapidity, atanh(beta), in [0, 30]");
    command.add_option("--heading", options.heading, "direction of motion in the world: x,y,z");
    command.add_option("--at", options.at, "the eye's event in the world: t,x,y,z in seconds and scene metres");
    command.add_option("--look", options.look,
                       "direction of the view, x,y,z in the world's axes boosted along the heading");
    command.add_option("--fov", options.field_of_view, "horizontal field of view, degrees");
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels (1280x720)");
}

void add_microwave_options(CLI::App& command, std::optional<bool>& microwave_background) {
    // Not as one flag with its opposite: CLI11 begins with false, where neither was given.
    command.add_flag_callback(
        "--microwave-background", [&] { microwave_background = true; },
        "the cosmic microwave background, 2.725 K, behind the sky (as the scenario says)");
    command.add_flag_callback(
        "--no-microwave-background", [&] { microwave_background = false; }, "a sky without it");
}

} // namespace engine

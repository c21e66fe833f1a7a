#include "engine/commands/camera_options.h"

#include "sim/bad_input.h"

#include <glm/geometric.hpp>

namespace engine {
namespace {

glm::dvec3 vector_option(const std::string& option, const std::string& text) {
    const std::vector<double> numbers = numbers_option(option, text, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

/// Refuses an option that the chosen camera would not use.
void check_company(const CameraOptions& options, CameraKind kind) {
    const bool world = kind == CameraKind::world;
    const bool placed = world || kind == CameraKind::free || kind == CameraKind::chase;
    if (options.at && !placed) {
        throw sim::BadInput("--camera-at", "", *options.at, "is for --camera world, free or chase");
    }
    if (options.velocity && !world) {
        throw sim::BadInput("--camera-velocity", "", *options.velocity, "is for --camera world");
    }
    if (options.look && !world) {
        throw sim::BadInput("--camera-look", "", *options.look, "is for --camera world");
    }
}

} // namespace

void add_camera_options(CLI::App& command, CameraOptions& options) {
    command.add_option("--camera", options.camera,
                       "whose eyes it is seen by: pilot, free (in the ship), world, chase or twin (pilot)");
    command.add_option("--camera-at", options.at,
                       "X,Y,Z in scene metres: world, where it is at world time 0; free and chase, right of, above and "
                       "behind the pilot");
    command.add_option("--camera-velocity", options.velocity, "X,Y,Z of the world's camera, in c (0,0,0)");
    command.add_option("--camera-look", options.look,
                       "X,Y,Z, where the world's camera looks (to where the ship is seen)");
    command.add_option("--ghost", options.ghosts, "a recording that flies along, any number of them")
        ->allow_extra_args(false);
}

CameraSettings camera_settings(const CameraOptions& options) {
    CameraSettings settings;
    if (options.camera) {
        settings.kind = named_option("--camera", *options.camera, camera_names);
    }
    check_company(options, settings.kind);
    if (options.at) {
        settings.place = vector_option("--camera-at", *options.at);
    }
    if (options.velocity) {
        settings.velocity = vector_option("--camera-velocity", *options.velocity);
        if (!(glm::length(settings.velocity) < 1.0)) {
            throw sim::BadInput("--camera-velocity", "", *options.velocity,
                                "must be slower than light: shorter than 1");
        }
    }
    if (options.look) {
        settings.look = direction_option("--camera-look", *options.look);
    }
    return settings;
}

} // namespace engine

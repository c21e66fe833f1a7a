#pragma once

#include "engine/cameras/camera_settings.h"

#include <CLI/App.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace engine {

/// The options of cameras and ghosts as they were typed.
struct CameraOptions {
    std::optional<std::string> camera;
    std::optional<std::string> at;
    std::optional<std::string> velocity;
    std::optional<std::string> look;
    std::vector<std::filesystem::path> ghosts;

    bool any() const { return camera || at || velocity || look || !ghosts.empty(); }
};

void add_camera_options(CLI::App& command, CameraOptions& options);

/// Throws sim::BadInput naming the option.
CameraSettings camera_settings(const CameraOptions& options);

} // namespace engine

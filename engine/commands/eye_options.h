#pragma once

#include "engine/picture_request.h"

#include <CLI/App.hpp>

#include <optional>

namespace engine {

/// The scenario and the options that say where the eye is, how it moves and what it looks at.
void add_eye_options(CLI::App& command, PictureOptions& options);

/// Options that put the microwave background behind the sky, or take it away from the scenario's.
void add_microwave_options(CLI::App& command, std::optional<bool>& microwave_background);

} // namespace engine

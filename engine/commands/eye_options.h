#pragma once

#include "engine/picture_request.h"

#include <CLI/App.hpp>

namespace engine {

/// The scenario and the options that say where the eye is, how it moves and what it looks at.
void add_eye_options(CLI::App& command, PictureOptions& options);

} // namespace engine

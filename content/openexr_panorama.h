#pragma once

#include "content/scene_desc.h"

#include <filesystem>
#include <string>
#include <vector>

namespace content {

/// The R, G and B channels (or Y alone, as grey) of an OpenEXR file as they stand. Throws sim::BadInput.
Panorama read_openexr(const std::filesystem::path& file, std::vector<std::string>& notes);

} // namespace content

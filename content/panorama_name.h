#pragma once

#include <filesystem>
#include <string_view>

namespace content {

/// Whether a panorama's name is that of one of the studio lights in Debian's blender-data package:
/// "studiolight:NAME.exr".
bool is_studiolight(std::string_view name);

/// Where the set-up puts that studio light in the cache folder, whether it is there or not.
std::filesystem::path studiolight_file(std::string_view name);

} // namespace content

#pragma once

#include "content/scene_desc.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace content {

/// A panorama from disk, and what was put right in it, one line each.
struct LoadedPanorama {
    Panorama panorama;
    std::vector<std::string> notes;
};

/// Loads an equirectangular sky: OpenEXR of any compression, Radiance .hdr, or PNG or JPEG, whose range is that of a
/// display (1 at most). Not finite or negative radiance is replaced and counted in the notes. Throws sim::BadInput when
/// the file is missing, broken, truncated, empty or larger than 2^27 pixels or 16384 along an edge.
LoadedPanorama load_panorama(const std::filesystem::path& file);

/// Throws sim::BadInput unless a picture of this size is loaded.
void check_panorama_size(long long width, long long height, const std::string& source);

/// Turned about +y by the whole number of columns nearest to `radians` (positive: from -z towards -x), its radiance
/// multiplied by `scale`.
void turn_and_scale(Panorama& panorama, double radians, float scale);

/// Whether a panorama's name is that of one of the studio lights in Debian's blender-data package:
/// "studiolight:NAME.exr".
bool is_studiolight(std::string_view name);

/// Where the set-up puts that studio light in the cache folder, whether it is there or not.
std::filesystem::path studiolight_file(std::string_view name);

} // namespace content

#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <span>
#include <string>

namespace content {

/// Decodes a Radiance RGBE picture (G. Ward, Graphics Gems II, 1991, II.5), plain or run-length encoded in either way,
/// rows from the top. Written here because the packaged stb_image never returns from some truncated files. Throws
/// sim::BadInput.
Panorama read_radiance(std::span<const std::uint8_t> bytes, const std::string& source);

} // namespace content

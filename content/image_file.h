#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <span>
#include <string>

namespace content {

/// The largest width or height of an image that is loaded.
inline constexpr int maximum_image_side = 16384;

/// Decodes a PNG or JPEG. Throws sim::BadInput with `source` and `field` when the bytes are neither, are truncated or
/// broken, or an edge is longer than maximum_image_side.
Image decode_image(std::span<const std::uint8_t> bytes, const std::string& source, const std::string& field);

} // namespace content

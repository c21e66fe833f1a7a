#pragma once

#include "content/scene_desc.h"

#include <cstdint>
#include <vector>

namespace content::generator {

/// An image as a PNG file with four channels, 8 bits each; the same image gives the same bytes.
std::vector<std::uint8_t> png_bytes(const Image& image);

} // namespace content::generator

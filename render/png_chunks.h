#pragma once

#include "render/colour/colour_space.h"
#include "render/picture_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace render {

/// A PNG file's bytes with what its pixels mean put behind its header: sRGB, or for Rec. 2020 a cICP chunk (primaries
/// 9, transfer 13, RGB, full range; PNG, third edition); and one iTXt chunk for each thing that the metadata say.
std::string with_png_chunks(std::string_view png, const PictureMetadata& metadata, Primaries primaries);

/// One chunk of a PNG file.
struct PngChunk {
    std::string type;
    std::string data;
};

/// The chunks of a PNG file in their order, to its end or to where it is not one.
std::vector<PngChunk> png_chunks(std::string_view png);

} // namespace render

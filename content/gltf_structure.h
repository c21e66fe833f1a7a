#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace content {

/// What surrounds the JSON text of a glTF file.
struct GltfSurroundings {
    std::string source;                 ///< the name that messages give the file
    std::filesystem::path folder;       ///< where relative URIs start
    std::size_t binary_chunk_bytes = 0; ///< length of a .glb's second chunk; 0 without one
};

/// Checks what the parser takes on trust or passes over in silence: JSON syntax and depth, the presence, type and range
/// of every property that is used, and that each buffer is there and long enough. Throws sim::BadInput naming the
/// property.
void check_gltf_structure(std::string_view json, const GltfSurroundings& surroundings);

} // namespace content

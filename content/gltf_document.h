#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <tiny_gltf.h>
#include <vector>

namespace content {

/// A parsed glTF file whose indices, ranges and numbers nobody has checked yet: the parser does not. Images are kept as
/// the encoded bytes of their file in tinygltf::Image::image, or stay in their buffer view.
struct GltfDocument {
    std::string source;           ///< the name that messages give the file
    std::filesystem::path folder; ///< that other files are relative to
    tinygltf::Model model;

    /// Throws sim::BadInput about a field of this file.
    [[noreturn]] void fail(const std::string& field, const std::string& value, const std::string& reason) const;

    /// `index` into a list of `size`, or BadInput naming `field`.
    std::size_t checked_index(int index, std::size_t size, const std::string& field) const;

    /// Every number must be finite and there must be `count` of them, or BadInput naming `field`.
    void check_numbers(const std::vector<double>& numbers, std::size_t count, const std::string& field) const;

    /// The bytes of a buffer view, checked to lie within its buffer.
    std::span<const std::uint8_t> view_bytes(int buffer_view, const std::string& field) const;
};

/// Parses .gltf text or .glb bytes and reads the buffers and images that it refers to, relative to `folder`. Throws
/// sim::BadInput when the container or the JSON is broken, a buffer is missing or too short, the version is not 2, or
/// an extension is required that is not supported.
GltfDocument parse_gltf(std::span<const std::uint8_t> bytes, const std::string& source,
                        const std::filesystem::path& folder);

} // namespace content

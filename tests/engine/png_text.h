#pragma once

#include "render/png_chunks.h"

#include <catch2/catch_test_macros.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace tests {

/// A file's bytes.
inline std::string contents(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What a PNG's metadata say of a thing; the test fails where they say nothing.
inline std::string png_text(const std::string& png, const std::string& name) {
    const std::string head = "rapidity:" + name + std::string(5, '\0');
    for (const render::PngChunk& chunk : render::png_chunks(png)) {
        if (chunk.type == "iTXt" && chunk.data.starts_with(head)) {
            return chunk.data.substr(head.size());
        }
    }
    FAIL("the picture does not say its " << name);
    return {};
}

} // namespace tests

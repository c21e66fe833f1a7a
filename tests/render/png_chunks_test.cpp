#include "render/png_chunks.h"

#include "content/file_bytes.h"
#include "content/image_file.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace {

content::Image small_image() {
    content::Image image;
    image.width = 2;
    image.height = 1;
    image.rgba = {10, 20, 30, 255, 200, 100, 50, 255};
    return image;
}

std::string written(const render::PictureMetadata& metadata, render::Primaries primaries) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("rapidity_png_" + std::to_string(::getpid()) + ".png");
    render::write_png(file, small_image(), metadata, primaries);
    const std::vector<std::uint8_t> bytes = content::read_file_bytes(file);
    CHECK(content::decode_image(bytes, file.string(), "").rgba == small_image().rgba);
    std::filesystem::remove(file);
    return {bytes.begin(), bytes.end()};
}

std::string data_of(const std::vector<render::PngChunk>& chunks, const std::string& type) {
    const auto found = std::find_if(chunks.begin(), chunks.end(), [&](const auto& c) { return c.type == type; });
    return found == chunks.end() ? "none" : found->data;
}

/// The checksum of PNG (ISO/IEC 15948 annex D), bit by bit.
std::uint32_t checksum(const std::string& bytes) {
    std::uint32_t value = 0xffffffffu;
    for (const char byte : bytes) {
        value ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            value = (value & 1u) != 0 ? 0xedb88320u ^ (value >> 1u) : value >> 1u;
        }
    }
    return ~value;
}

} // namespace

TEST_CASE("a PNG says how it was made and which colours its numbers are") {
    const std::string bytes =
        written({{"beta", 0.9}, {"scenario", "street"}, {"look", glm::dvec3(1.0, 0.0, -2.5)}}, render::Primaries::srgb);
    const std::vector<render::PngChunk> chunks = render::png_chunks(bytes);
    REQUIRE(chunks.size() >= 6);
    CHECK(chunks.front().type == "IHDR");
    CHECK(chunks.back().type == "IEND");
    CHECK(data_of(chunks, "sRGB") == std::string(1, '\0'));
    CHECK(data_of(chunks, "cICP") == "none");
    const std::string gap(5, '\0');
    const std::array<std::string, 3> texts{"rapidity:beta" + gap + "0.9", "rapidity:look" + gap + "1 0 -2.5",
                                           "rapidity:scenario" + gap + "street"};
    for (const std::string& text : texts) {
        CHECK(std::any_of(chunks.begin(), chunks.end(),
                          [&](const auto& c) { return c.type == "iTXt" && c.data == text; }));
    }
    for (const render::PngChunk& chunk : chunks) {
        const std::uint32_t sum = checksum(chunk.type + chunk.data);
        std::string stored;
        for (const unsigned shift : {24u, 16u, 8u, 0u}) {
            stored += static_cast<char>((sum >> shift) & 0xffu);
        }
        CHECK(bytes.find(chunk.type + chunk.data + stored) != std::string::npos);
    }
}

TEST_CASE("a PNG of wide gamut says so by cICP") {
    const std::vector<render::PngChunk> chunks = render::png_chunks(written({}, render::Primaries::rec2020));
    CHECK(data_of(chunks, "cICP") == std::string("\x09\x0d\x00\x01", 4));
    CHECK(data_of(chunks, "sRGB") == "none");
}

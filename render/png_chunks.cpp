#include "render/png_chunks.h"

#include <cstdint>
#include <fmt/format.h>
#include <variant>
#include <zlib.h>

namespace render {
namespace {

constexpr std::size_t signature_size = 8;
constexpr std::size_t chunk_overhead = 12; // length, type, checksum
constexpr std::size_t header_end = signature_size + chunk_overhead + 13;

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (unsigned shift = 24; shift < 32; shift -= 8) {
        bytes += static_cast<char>((value >> shift) & 0xffu);
    }
    return bytes;
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = (value << 8u) | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

std::string chunk(const std::string& type, const std::string& data) {
    const std::string covered = type + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(covered.data());
    const auto checksum = static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(covered.size())));
    return big_endian(static_cast<std::uint32_t>(data.size())) + covered + big_endian(checksum);
}

std::string text_of(const PictureMetadata::mapped_type& value) {
    if (const auto* text = std::get_if<std::string>(&value)) {
        return *text;
    }
    if (const auto* number = std::get_if<double>(&value)) {
        return fmt::format("{}", *number);
    }
    const auto& vector = std::get<glm::dvec3>(value);
    return fmt::format("{} {} {}", vector.x, vector.y, vector.z);
}

} // namespace

std::string with_png_chunks(std::string_view png, const PictureMetadata& metadata, Primaries primaries) {
    std::string result(png.substr(0, header_end));
    if (primaries == Primaries::rec2020) {
        result += chunk("cICP", {'\x09', '\x0d', '\x00', '\x01'});
    } else {
        result += chunk("sRGB", {'\x00'}); // perceptual intent
    }
    for (const auto& [name, value] : metadata) {
        // Keyword; not compressed; no language, no translation; UTF-8.
        result += chunk("iTXt", "rapidity:" + name + std::string(5, '\0') + text_of(value));
    }
    return result.append(png.substr(header_end));
}

std::vector<PngChunk> png_chunks(std::string_view png) {
    std::vector<PngChunk> chunks;
    for (std::size_t at = signature_size; at + chunk_overhead <= png.size();) {
        const std::size_t length = number_at(png, at);
        if (length > png.size() - at - chunk_overhead) {
            break;
        }
        chunks.push_back({std::string(png.substr(at + 4, 4)), std::string(png.substr(at + 8, length))});
        at += length + chunk_overhead;
    }
    return chunks;
}

} // namespace render

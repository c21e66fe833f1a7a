#include "content/gltf_document.h"

#include "content/file_bytes.h"
#include "content/gltf_structure.h"
#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <system_error>

namespace content {
namespace {

constexpr std::array<std::string_view, 5> supported_extensions = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization",
    "KHR_texture_transform"};

bool is_supported(const std::string& extension) {
    return std::find(supported_extensions.begin(), supported_extensions.end(), extension) != supported_extensions.end();
}

std::uint32_t little_endian_word(std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        word |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
    }
    return word;
}

bool is_binary_container(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

struct Container {
    std::string_view json;
    std::size_t binary_chunk_bytes = 0;
};

// The two chunks of a .glb, after checking the header and their lengths (glTF 2.0 specification, 4.4).
Container open_container(std::span<const std::uint8_t> bytes, const std::string& source) {
    constexpr std::size_t header_bytes = 12;
    constexpr std::size_t chunk_header_bytes = 8;
    if (bytes.size() < header_bytes + chunk_header_bytes) {
        throw sim::BadInput(source, "header", "", "the file is truncated");
    }
    const std::uint32_t version = little_endian_word(bytes, 4);
    if (version != 2) {
        throw sim::BadInput(source, "header.version", std::to_string(version), "only glTF 2 is read");
    }
    const std::size_t length = little_endian_word(bytes, 8);
    if (length > bytes.size()) {
        throw sim::BadInput(source, "header.length", std::to_string(length),
                            fmt::format("the file is truncated: it has {} bytes", bytes.size()));
    }
    Container container;
    std::size_t offset = header_bytes;
    for (int chunk = 0; chunk < 2 && offset < length; ++chunk) {
        const std::string field = fmt::format("chunks[{}].length", chunk);
        if (length - offset < chunk_header_bytes) {
            throw sim::BadInput(source, field, "", "the chunk is truncated");
        }
        const std::size_t chunk_length = little_endian_word(bytes, offset);
        if (chunk_length > length - offset - chunk_header_bytes) {
            throw sim::BadInput(source, field, std::to_string(chunk_length), "the chunk is longer than the file");
        }
        if (chunk == 0) {
            container.json = {reinterpret_cast<const char*>(bytes.data()) + offset + chunk_header_bytes, chunk_length};
        } else {
            container.binary_chunk_bytes = chunk_length;
        }
        offset += chunk_header_bytes + chunk_length;
    }
    return container;
}

// The parser's callbacks. It catches nothing, so neither of them throws.
bool keep_encoded_image(tinygltf::Image* image, int /*index*/, std::string* /*error*/, std::string* /*warning*/,
                        int /*width*/, int /*height*/, const unsigned char* bytes, int size, void* /*user*/) {
    // An image in a buffer view is read after the view has been checked; here its bytes may lie outside.
    if (image->bufferView < 0) {
        image->image.assign(bytes, bytes + size);
    }
    return true;
}

bool file_exists(const std::string& file, void* /*user*/) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

std::string same_path(const std::string& file, void* /*user*/) {
    return file;
}

bool read_file(std::vector<unsigned char>* bytes, std::string* error, const std::string& file, void* /*user*/) {
    try {
        *bytes = read_file_bytes(file);
        return true;
    } catch (const sim::BadInput& problem) {
        if (error != nullptr) {
            *error = problem.what();
        }
        return false;
    }
}

void check_images(const GltfDocument& document) {
    for (std::size_t i = 0; i < document.model.images.size(); ++i) {
        const tinygltf::Image& image = document.model.images[i];
        if (image.bufferView < 0 && image.image.empty()) {
            document.fail(fmt::format("images[{}].uri", i), image.uri, "the image cannot be read");
        }
    }
}

void check_version_and_extensions(const GltfDocument& document) {
    if (document.model.asset.version.rfind("2.", 0) != 0) {
        document.fail("asset.version", document.model.asset.version, "only glTF 2 is read");
    }
    const auto& required = document.model.extensionsRequired;
    for (std::size_t i = 0; i < required.size(); ++i) {
        if (!is_supported(required[i])) {
            document.fail(fmt::format("extensionsRequired[{}]", i), required[i],
                          fmt::format("not supported; supported are {}", fmt::join(supported_extensions, ", ")));
        }
    }
}

bool refuse_to_write(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
}

[[maybe_unused]] bool file_size(std::size_t* bytes, std::string*, const std::string& file, void*) {
    std::error_code error;
    *bytes = std::filesystem::file_size(file, error);
    return !error;
}

/// tinygltf 2.9 (Debian 13) asks for a file's size as well, and takes all of the callbacks or none.
template <class Callbacks>
Callbacks file_callbacks() {
    Callbacks callbacks{};
    callbacks.FileExists = &file_exists;
    callbacks.ExpandFilePath = &same_path;
    callbacks.ReadWholeFile = &read_file;
    callbacks.WriteWholeFile = &refuse_to_write;
    if constexpr (requires { callbacks.GetFileSizeInBytes; }) {
        callbacks.GetFileSizeInBytes = &file_size;
    }
    return callbacks;
}

} // namespace

void GltfDocument::fail(const std::string& field, const std::string& value, const std::string& reason) const {
    throw sim::BadInput(source, field, value, reason);
}

std::size_t GltfDocument::checked_index(int index, std::size_t size, const std::string& field) const {
    if (index < 0 || static_cast<std::size_t>(index) >= size) {
        fail(field, std::to_string(index), fmt::format("there are {} to refer to", size));
    }
    return static_cast<std::size_t>(index);
}

void GltfDocument::check_numbers(const std::vector<double>& numbers, std::size_t count,
                                 const std::string& field) const {
    if (numbers.size() != count) {
        fail(field, fmt::format("{} numbers", numbers.size()), fmt::format("must be {}", count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        // Single precision is what scenes are kept in.
        if (!std::isfinite(static_cast<float>(numbers[i]))) {
            fail(fmt::format("{}[{}]", field, i), fmt::format("{}", numbers[i]), "not a finite number");
        }
    }
}

std::span<const std::uint8_t> GltfDocument::view_bytes(int buffer_view, const std::string& field) const {
    const std::size_t view_index = checked_index(buffer_view, model.bufferViews.size(), field);
    const tinygltf::BufferView& view = model.bufferViews[view_index];
    const std::string view_field = fmt::format("bufferViews[{}]", view_index);
    const auto& data = model.buffers[checked_index(view.buffer, model.buffers.size(), view_field + ".buffer")].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
        fail(view_field + ".byteLength", std::to_string(view.byteLength),
             fmt::format("with byteOffset {} it reaches beyond the buffer's {} bytes", view.byteOffset, data.size()));
    }
    return std::span(data).subspan(view.byteOffset, view.byteLength);
}

GltfDocument parse_gltf(std::span<const std::uint8_t> bytes, const std::string& source,
                        const std::filesystem::path& folder) {
    const bool binary = is_binary_container(bytes);
    const Container container =
        binary ? open_container(bytes, source)
               : Container{std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()), 0};
    check_gltf_structure(container.json, {source, folder, container.binary_chunk_bytes});

    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(&keep_encoded_image, nullptr);
    parser.SetFsCallbacks(file_callbacks<tinygltf::FsCallbacks>());
    GltfDocument document;
    document.source = source;
    document.folder = folder;
    std::string error;
    std::string warning;
    bool parsed = false;
    try {
        const auto size = static_cast<unsigned int>(bytes.size());
        parsed =
            binary ? parser.LoadBinaryFromMemory(&document.model, &error, &warning, bytes.data(), size, folder.string())
                   : parser.LoadASCIIFromString(&document.model, &error, &warning,
                                                reinterpret_cast<const char*>(bytes.data()), size, folder.string());
    } catch (const std::exception&) {
        parsed = false;
    }
    if (!parsed) {
        throw sim::BadInput(source, "", "", "not a usable glTF 2.0 file");
    }
    check_version_and_extensions(document);
    check_images(document);
    return document;
}

} // namespace content

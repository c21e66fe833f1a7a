#pragma once

#include "content/gltf.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

/// Small glTF files written out by hand, so that the loader is not tested with a writer of the same house.
namespace samples {

using Bytes = std::vector<std::uint8_t>;

/// A PNG of 2 x 2 pixels: red, green / blue, grey 188 without alpha.
inline constexpr std::array<std::uint8_t, 79> png = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52,
    0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x06, 0x00, 0x00, 0x00, 0x72, 0xb6, 0x0d,
    0x24, 0x00, 0x00, 0x00, 0x16, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0xf8, 0xcf, 0xc0, 0xf0,
    0x1f, 0x0c, 0x81, 0xf4, 0xff, 0x3d, 0x7b, 0xf6, 0x30, 0x00, 0x00, 0x46, 0x6e, 0x08, 0x2f, 0x32,
    0x80, 0xe3, 0xd0, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
inline const std::string png_data_uri =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAFklEQVR42mP4"
    "z8DwHwyB9P89e/YwAABGbggvMoDj0AAAAABJRU5ErkJggg==";

/// Appends to the binary chunk and to the lists of buffer views and accessors; then writes the file.
class GltfSample {
  public:
    template <class Component>
    int view(const std::vector<Component>& components, int byte_stride = 0) {
        while (binary_.size() % 4 != 0) {
            binary_.push_back(0);
        }
        const std::size_t offset = binary_.size();
        const std::size_t length = components.size() * sizeof(Component);
        binary_.resize(offset + length);
        std::memcpy(binary_.data() + offset, components.data(), length);
        const std::string stride = byte_stride > 0 ? fmt::format(", \"byteStride\": {}", byte_stride) : "";
        views_.push_back(
            fmt::format(R"({{"buffer": 0, "byteOffset": {}, "byteLength": {}{}}})", offset, length, stride));
        return static_cast<int>(views_.size()) - 1;
    }

    /// `more`: further members, such as "normalized": true.
    int accessor(int buffer_view, int component_type, std::size_t count, const std::string& type,
                 const std::string& more = "") {
        const std::string from = buffer_view >= 0 ? fmt::format("\"bufferView\": {}, ", buffer_view) : "";
        accessors_.push_back(fmt::format(R"({{{}"componentType": {}, "count": {}, "type": "{}"{}{}}})", from,
                                         component_type, count, type, more.empty() ? "" : ", ", more));
        return static_cast<int>(accessors_.size()) - 1;
    }

    int floats(const std::vector<float>& values, int components) {
        static constexpr std::array<const char*, 5> types = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        return accessor(view(values), 5126, values.size() / static_cast<std::size_t>(components),
                        types.at(static_cast<std::size_t>(components)));
    }

    int indices(const std::vector<std::uint16_t>& values) {
        return accessor(view(values), 5123, values.size(), "SCALAR");
    }

    /// A .glb with `rest` as the other members of the root, such as "nodes": [...].
    Bytes glb(const std::string& rest) const {
        std::string json = fmt::format(
            R"({{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {}}}], "bufferViews": [{}], "accessors": [{}])",
            binary_.size(), fmt::join(views_, ", "), fmt::join(accessors_, ", "));
        json += rest.empty() ? "}" : ", " + rest + "}";
        return container(json, binary_);
    }

    static Bytes container(std::string json, Bytes binary) {
        json.resize((json.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, 0);
        Bytes file;
        const auto word = [&](std::size_t value) {
            for (unsigned shift = 0; shift < 32; shift += 8) {
                file.push_back(static_cast<std::uint8_t>(value >> shift));
            }
        };
        word(0x46546C67);
        word(2);
        word(12 + 8 + json.size() + 8 + binary.size());
        word(json.size());
        word(0x4E4F534A);
        file.insert(file.end(), json.begin(), json.end());
        word(binary.size());
        word(0x004E4942);
        file.insert(file.end(), binary.begin(), binary.end());
        return file;
    }

  private:
    Bytes binary_;
    std::vector<std::string> views_;
    std::vector<std::string> accessors_;
};

/// A square of two triangles in the plane z = 0 with everything that a mesh can have, a texture in a buffer view, a
/// lamp, a sun and a camera.
inline Bytes square_glb() {
    GltfSample sample;
    const int positions = sample.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
    const int normals = sample.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 2}, 3);
    const int coordinates = sample.floats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
    const int colours = sample.floats({1, 1, 1, 0.5f, 1, 1, 1, 0, 1, 0.25f, 1, 1}, 3);
    const int indices = sample.indices({0, 1, 2, 0, 2, 3});
    const int image = sample.view(std::vector<std::uint8_t>(png.begin(), png.end()));
    return sample.glb(fmt::format(
        R"("scene": 0, "scenes": [{{"nodes": [0, 2, 3, 4]}}],
        "nodes": [{{"name": "parent", "translation": [10, 0, 0], "children": [1]}},
                  {{"name": "square", "mesh": 0, "rotation": [0, 0.70710678118, 0, 0.70710678118], "scale": [2, 3, 4]}},
                  {{"name": "lamp", "translation": [1, 2, 3], "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}},
                  {{"name": "sun", "rotation": [-0.70710678118, 0, 0, 0.70710678118],
                    "extensions": {{"KHR_lights_punctual": {{"light": 1}}}}}},
                  {{"name": "eye", "matrix": [0,0,-1,0, 0,1,0,0, 1,0,0,0, 5,6,7,1], "camera": 0}}],
        "meshes": [{{"name": "quad", "primitives": [{{"material": 0, "indices": {},
            "attributes": {{"POSITION": {}, "NORMAL": {}, "TEXCOORD_0": {}, "COLOR_0": {}}}}}]}}],
        "materials": [{{"name": "paint", "pbrMetallicRoughness": {{"baseColorFactor": [0.5, 0.25, 1, 1],
            "baseColorTexture": {{"index": 0}}}}, "emissiveFactor": [1, 0.5, 0], "alphaMode": "MASK",
            "alphaCutoff": 0.25, "doubleSided": true, "extras": {{"rapidity": {{"temperature_K": 3000}}}},
            "extensions": {{"KHR_materials_emissive_strength": {{"emissiveStrength": 4}}}}}}],
        "textures": [{{"source": 0}}], "images": [{{"bufferView": {}, "mimeType": "image/png", "name": "four"}}],
        "cameras": [{{"type": "perspective", "perspective": {{"yfov": 1.0471975512, "aspectRatio": 1.5, "znear": 0.1}}}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {{"KHR_lights_punctual": {{"lights": [
            {{"type": "point", "color": [1, 0.5, 0.25], "intensity": 8, "range": 20}},
            {{"type": "directional", "intensity": 3}}]}}}})",
        indices, positions, normals, coordinates, colours, image));
}

inline content::SceneDesc load(const Bytes& bytes) {
    return content::load_gltf(bytes, "sample.glb", ".");
}

inline content::SceneDesc load_text(const std::string& json) {
    return content::load_gltf(Bytes(json.begin(), json.end()), "sample.gltf", ".");
}

/// A .glb with one triangle mesh, whose primitive has the given members, at the origin.
inline Bytes with_primitive(const GltfSample& sample, const std::string& primitive) {
    return sample.glb(fmt::format(R"("nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{{{}}}]}}])", primitive));
}

inline const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

/// A file that has some bytes, for a container without any is none.
inline GltfSample with_bytes() {
    GltfSample sample;
    sample.floats({0, 0, 0}, 3);
    return sample;
}

} // namespace samples

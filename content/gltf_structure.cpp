#include "content/gltf_structure.h"

#include "sim/bad_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <system_error>

namespace content {
namespace {

using Json = nlohmann::json;

enum class Kind : std::uint8_t { index, length, number, text, flag, indices, index_map, numbers, object, spectrum };

struct Rule {
    std::string_view path; // a[].b: property b of every element of the array a
    Kind kind;
    bool required = false; // wherever the object that holds it is there
    std::size_t count = 0; // of numbers; 0: any
};

constexpr bool required = true;
constexpr std::array rules = {
    Rule{"asset", Kind::object, required},
    Rule{"asset.version", Kind::text, required},
    Rule{"buffers[].byteLength", Kind::length, required},
    Rule{"buffers[].uri", Kind::text},
    Rule{"bufferViews[].buffer", Kind::index, required},
    Rule{"bufferViews[].byteOffset", Kind::length},
    Rule{"bufferViews[].byteLength", Kind::length, required},
    Rule{"bufferViews[].byteStride", Kind::length},
    Rule{"accessors[].bufferView", Kind::index},
    Rule{"accessors[].byteOffset", Kind::length},
    Rule{"accessors[].componentType", Kind::index, required},
    Rule{"accessors[].count", Kind::length, required},
    Rule{"accessors[].type", Kind::text, required},
    Rule{"accessors[].normalized", Kind::flag},
    Rule{"accessors[].sparse.count", Kind::index, required},
    Rule{"accessors[].sparse.indices", Kind::object, required},
    Rule{"accessors[].sparse.indices.bufferView", Kind::index, required},
    Rule{"accessors[].sparse.indices.byteOffset", Kind::index},
    Rule{"accessors[].sparse.indices.componentType", Kind::index, required},
    Rule{"accessors[].sparse.values", Kind::object, required},
    Rule{"accessors[].sparse.values.bufferView", Kind::index, required},
    Rule{"accessors[].sparse.values.byteOffset", Kind::index},
    Rule{"meshes[].primitives[].attributes", Kind::index_map, required},
    Rule{"meshes[].primitives[].indices", Kind::index},
    Rule{"meshes[].primitives[].material", Kind::index},
    Rule{"meshes[].primitives[].mode", Kind::index},
    Rule{"scene", Kind::index},
    Rule{"scenes[].nodes", Kind::indices},
    Rule{"nodes[].children", Kind::indices},
    Rule{"nodes[].mesh", Kind::index},
    Rule{"nodes[].camera", Kind::index},
    Rule{"nodes[].matrix", Kind::numbers},
    Rule{"nodes[].translation", Kind::numbers},
    Rule{"nodes[].rotation", Kind::numbers},
    Rule{"nodes[].scale", Kind::numbers},
    Rule{"nodes[].extensions.KHR_lights_punctual.light", Kind::index, required},
    Rule{"materials[].pbrMetallicRoughness.baseColorFactor", Kind::numbers, false, 4},
    Rule{"materials[].pbrMetallicRoughness.baseColorTexture.index", Kind::index, required},
    Rule{"materials[].pbrMetallicRoughness.baseColorTexture.texCoord", Kind::index},
    Rule{"materials[].emissiveFactor", Kind::numbers, false, 3},
    Rule{"materials[].emissiveTexture.index", Kind::index, required},
    Rule{"materials[].emissiveTexture.texCoord", Kind::index},
    Rule{"materials[].alphaMode", Kind::text},
    Rule{"materials[].alphaCutoff", Kind::number},
    Rule{"materials[].doubleSided", Kind::flag},
    Rule{"materials[].extensions.KHR_materials_emissive_strength.emissiveStrength", Kind::number},
    Rule{"materials[].extras.rapidity.temperature_K", Kind::number},
    Rule{"materials[].extras.rapidity.ultraviolet_reflectance", Kind::number},
    Rule{"materials[].extras.rapidity.infrared_reflectance", Kind::number},
    Rule{"materials[].extras.rapidity.ultraviolet_emission", Kind::number},
    Rule{"materials[].extras.rapidity.infrared_emission", Kind::number},
    Rule{"materials[].extras.rapidity.vegetation", Kind::flag},
    Rule{"materials[].extras.rapidity.reflectance_spectrum", Kind::spectrum},
    Rule{"materials[].extras.rapidity.emission_spectrum", Kind::spectrum},
    Rule{"textures[].source", Kind::index},
    Rule{"textures[].sampler", Kind::index},
    Rule{"images[].uri", Kind::text},
    Rule{"images[].bufferView", Kind::index},
    Rule{"cameras[].type", Kind::text, required},
    Rule{"cameras[].perspective.yfov", Kind::number, required},
    Rule{"cameras[].perspective.aspectRatio", Kind::number},
    Rule{"extensions.KHR_lights_punctual.lights[].type", Kind::text, required},
    Rule{"extensions.KHR_lights_punctual.lights[].color", Kind::numbers, false, 3},
    Rule{"extensions.KHR_lights_punctual.lights[].intensity", Kind::number},
    Rule{"extensions.KHR_lights_punctual.lights[].range", Kind::number},
    Rule{"extensions.KHR_lights_punctual.lights[].extras.rapidity.temperature_K", Kind::number},
    Rule{"extensions.KHR_lights_punctual.lights[].extras.rapidity.spectrum", Kind::spectrum},
};

class Checker {
  public:
    explicit Checker(const std::string& source) : source_(source) {}

    // `shown`: the path of `holder`, for messages; `path`: what is left of the rule's path below it.
    void check(const Json& holder, std::string_view path, const std::string& shown, const Rule& rule) const {
        if (!holder.is_object()) {
            if (shown.ends_with(".extras")) {
                return; // may be anything
            }
            fail(shown.empty() ? "root" : shown, holder, "must be an object");
        }
        const std::size_t dot = path.find('.');
        const bool last = dot == std::string_view::npos;
        std::string name(path.substr(0, dot));
        const bool list = name.size() > 2 && name.substr(name.size() - 2) == "[]";
        if (list) {
            name.resize(name.size() - 2);
        }
        const std::string field = shown.empty() ? name : shown + "." + name;
        const auto found = holder.find(name);
        if (found == holder.end()) {
            if (last && rule.required) {
                throw sim::BadInput(source_, field, "", "is missing");
            }
            return;
        }
        if (last) {
            check_value(*found, field, rule.kind);
            require(rule.count == 0 || found->size() == rule.count, *found, field,
                    fmt::format("must be {} numbers", rule.count)); // tinygltf takes its default instead
            return;
        }
        const std::string_view rest = path.substr(dot + 1);
        if (!list) {
            check(*found, rest, field, rule);
            return;
        }
        if (!found->is_array()) {
            fail(field, *found, "must be an array");
        }
        for (std::size_t i = 0; i < found->size(); ++i) {
            check((*found)[i], rest, fmt::format("{}[{}]", field, i), rule);
        }
    }

  private:
    [[noreturn]] void fail(const std::string& field, const Json& value, const std::string& reason) const {
        constexpr std::size_t longest_shown = 60;
        std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
        if (text.size() > longest_shown) {
            text = text.substr(0, longest_shown) + "...";
        }
        throw sim::BadInput(source_, field, text, reason);
    }

    void check_value(const Json& value, const std::string& field, Kind kind) const {
        switch (kind) {
        case Kind::index:
            check_whole(value, field, std::uint64_t{0x7FFFFFFF});
            break;
        case Kind::length:
            check_whole(value, field, std::uint64_t{1} << 40U);
            break;
        case Kind::number:
            check_number(value, field);
            break;
        case Kind::text:
            require(value.is_string(), value, field, "must be a text");
            break;
        case Kind::flag:
            require(value.is_boolean(), value, field, "must be true or false");
            break;
        case Kind::object:
            require(value.is_object(), value, field, "must be an object");
            break;
        case Kind::spectrum: // tinygltf leaves empty lists out
            require(value.is_string() || (value.is_array() && !value.empty()), value, field,
                    "must be a list of [nm, value] or the name of a CSV file");
            for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
                require(value[i].is_array() && value[i].size() == 2, value[i], fmt::format("{}[{}]", field, i),
                        "must be two numbers, [nm, value]");
                check_value(value[i], fmt::format("{}[{}]", field, i), Kind::numbers);
            }
            break;
        case Kind::index_map:
            require(value.is_object(), value, field, "must be an object");
            for (const auto& [key, element] : value.items()) {
                check_value(element, fmt::format("{}.{}", field, key), Kind::index);
            }
            break;
        case Kind::indices:
        case Kind::numbers:
            require(value.is_array(), value, field, "must be an array");
            for (std::size_t i = 0; i < value.size(); ++i) {
                check_value(value[i], fmt::format("{}[{}]", field, i),
                            kind == Kind::indices ? Kind::index : Kind::number);
            }
            break;
        }
    }

    void require(bool holds, const Json& value, const std::string& field, const std::string& reason) const {
        if (!holds) {
            fail(field, value, reason);
        }
    }

    void check_whole(const Json& value, const std::string& field, std::uint64_t largest) const {
        require(value.is_number_unsigned() && value.get<std::uint64_t>() <= largest, value, field,
                fmt::format("must be a whole number in 0 to {}", largest));
    }

    void check_number(const Json& value, const std::string& field) const {
        require(value.is_number() && std::isfinite(value.get<double>()), value, field, "must be a finite number");
    }

    const std::string& source_;
};

// The parser calls itself once for each level, so that a file made of brackets alone would exhaust the stack.
void check_depth(std::string_view json, const std::string& source) {
    constexpr int deepest = 64;
    int depth = 0;
    bool in_text = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_text) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                in_text = false;
            }
        } else if (c == '"') {
            in_text = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepest) {
                throw sim::BadInput(source, fmt::format("byte {}", i), "",
                                    fmt::format("JSON nested more than {} deep", deepest));
            }
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

/// The word at a byte counted from 1, such as a number that JSON does not know.
std::string word_at(std::string_view text, std::size_t byte) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-.";
    if (byte == 0 || byte > text.size()) {
        return "";
    }
    const std::size_t at = byte - 1;
    const std::size_t before = text.substr(0, at).find_last_not_of(letters);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    constexpr std::size_t longest_shown = 60;
    return std::string(text.substr(first, std::min(text.find_first_not_of(letters, first) - first, longest_shown)));
}

Json parse(std::string_view text, const std::string& source) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw sim::BadInput(source, fmt::format("byte {} of the JSON", error.byte), word_at(text, error.byte),
                            "the JSON is broken here");
    } catch (const Json::exception&) {
        throw sim::BadInput(source, "", "", "the JSON holds a number that is out of range");
    }
}

void check_buffers(const Json& root, const GltfSurroundings& surroundings) {
    const auto buffers = root.find("buffers");
    if (buffers == root.end()) {
        return;
    }
    for (std::size_t i = 0; i < buffers->size(); ++i) {
        const Json& buffer = (*buffers)[i];
        const auto length = buffer["byteLength"].get<std::uint64_t>();
        const std::string field = fmt::format("buffers[{}]", i);
        if (length == 0) {
            throw sim::BadInput(surroundings.source, field + ".byteLength", "0", "must be positive");
        }
        if (!buffer.contains("uri")) {
            if (i != 0 || surroundings.binary_chunk_bytes < length) {
                throw sim::BadInput(surroundings.source, field + ".byteLength", std::to_string(length),
                                    fmt::format("the binary chunk has {} bytes", surroundings.binary_chunk_bytes));
            }
            continue;
        }
        const auto uri = buffer["uri"].get<std::string>();
        if (uri.rfind("data:", 0) == 0) {
            // Base64 holds three bytes in four letters.
            if (uri.size() / 4 * 3 + 3 < length) {
                throw sim::BadInput(surroundings.source, field + ".byteLength", std::to_string(length),
                                    "the data URI is shorter");
            }
        } else if (uri.find('%') == std::string::npos) {
            std::error_code error;
            const auto size = std::filesystem::file_size(surroundings.folder / uri, error);
            if (error) {
                throw sim::BadInput(surroundings.source, field + ".uri", uri, "the file cannot be read");
            }
            if (size < length) {
                throw sim::BadInput(surroundings.source, field + ".byteLength", std::to_string(length),
                                    fmt::format("{} has {} bytes", uri, size));
            }
        }
    }
}

} // namespace

void check_gltf_structure(std::string_view json, const GltfSurroundings& surroundings) {
    check_depth(json, surroundings.source);
    const Json root = parse(json, surroundings.source);
    const Checker checker(surroundings.source);
    for (const Rule& rule : rules) {
        checker.check(root, rule.path, "", rule);
    }
    check_buffers(root, surroundings);
}

} // namespace content

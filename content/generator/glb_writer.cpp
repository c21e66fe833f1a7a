#include "content/generator/glb_writer.h"

#include "content/generator/png_bytes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <string>

namespace content::generator {
namespace {

using Json = nlohmann::json;

constexpr int float_component = 5126;
constexpr int unsigned_int_component = 5125;
constexpr int vertex_target = 34962;
constexpr int index_target = 34963;

Json numbers(const float* values, int count) {
    Json list = Json::array();
    for (int i = 0; i < count; ++i) {
        list.push_back(values[i]);
    }
    return list;
}

Json numbers(const glm::vec3& value) {
    return numbers(glm::value_ptr(value), 3);
}

/// Builds the JSON and the binary chunk together.
class GlbWriter {
  public:
    explicit GlbWriter(const SceneDesc& scene) : scene_(scene) {
        root_["asset"] = {{"version", "2.0"}, {"generator", std::string("Rapidity ") + RAPIDITY_VERSION}};
        root_["scene"] = 0;
        root_["scenes"] = Json::array({{{"name", scene.name}, {"nodes", Json::array()}}});
    }

    std::vector<std::uint8_t> write() {
        write_images();
        for (const Material& material : scene_.materials) {
            root_["materials"].push_back(material_json(material));
        }
        for (const Mesh& mesh : scene_.meshes) {
            root_["meshes"].push_back(mesh_json(mesh));
        }
        for (const Instance& instance : scene_.instances) {
            add_node({{"name", instance.name}, {"mesh", instance.mesh}}, instance.world_from_mesh);
        }
        write_lamps();
        write_cameras();
        if (!extensions_.empty()) {
            root_["extensionsUsed"] = extensions_;
        }
        if (!binary_.empty()) {
            root_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
        }
        return file();
    }

  private:
    std::size_t add_view(const void* data, std::size_t size) {
        const std::size_t offset = binary_.size();
        const auto* first = static_cast<const std::uint8_t*>(data);
        binary_.insert(binary_.end(), first, first + size);
        binary_.resize((binary_.size() + 3) / 4 * 4, 0);
        root_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        return root_["bufferViews"].size() - 1;
    }

    template <typename Element>
    std::size_t add_accessor(const std::vector<Element>& values, const char* type, int component, int target) {
        const std::size_t view = add_view(values.data(), values.size() * sizeof(Element));
        root_["bufferViews"][view]["target"] = target;
        root_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", values.size()}, {"type", type}});
        return root_["accessors"].size() - 1;
    }

    template <typename Element>
    std::size_t add_attribute(const Mesh& mesh, Element Vertex::*member, const char* type) {
        std::vector<Element> values;
        values.reserve(mesh.vertices.size());
        for (const Vertex& vertex : mesh.vertices) {
            values.push_back(vertex.*member);
        }
        return add_accessor(values, type, float_component, vertex_target);
    }

    void write_images() {
        if (scene_.images.empty()) {
            return;
        }
        constexpr int linear_filter = 9729;
        constexpr int trilinear_filter = 9987;
        root_["samplers"] = Json::array({{{"magFilter", linear_filter}, {"minFilter", trilinear_filter}}});
        for (const Image& image : scene_.images) {
            const std::vector<std::uint8_t> png = png_bytes(image);
            const std::size_t view = add_view(png.data(), png.size());
            root_["images"].push_back({{"name", image.name}, {"mimeType", "image/png"}, {"bufferView", view}});
            root_["textures"].push_back({{"sampler", 0}, {"source", root_["images"].size() - 1}});
        }
    }

    Json material_json(const Material& material) {
        Json pbr = {{"baseColorFactor", numbers(glm::value_ptr(material.base_colour), 4)},
                    {"metallicFactor", 0.0},
                    {"roughnessFactor", 0.9}};
        if (material.base_colour_image) {
            pbr["baseColorTexture"] = {{"index", *material.base_colour_image}};
        }
        Json json = {{"name", material.name}, {"pbrMetallicRoughness", pbr}, {"doubleSided", material.double_sided}};
        const float strength = std::max({material.emission.r, material.emission.g, material.emission.b});
        if (strength > 0.0f) {
            json["emissiveFactor"] = numbers(strength > 1.0f ? material.emission / strength : material.emission);
        }
        if (strength > 1.0f) {
            json["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
            extensions_.insert("KHR_materials_emissive_strength");
        }
        if (material.emission_image) {
            json["emissiveTexture"] = {{"index", *material.emission_image}};
        }
        if (material.emission_temperature) {
            json["extras"]["rapidity"]["temperature_K"] = *material.emission_temperature;
        }
        if (material.vegetation) {
            json["extras"]["rapidity"]["vegetation"] = true;
        }
        if (material.alpha_mode == AlphaMode::mask) {
            json["alphaMode"] = "MASK";
            json["alphaCutoff"] = material.alpha_cutoff;
        }
        if (material.unlit) {
            json["extensions"]["KHR_materials_unlit"] = Json::object();
            extensions_.insert("KHR_materials_unlit");
        }
        return json;
    }

    Json mesh_json(const Mesh& mesh) {
        Json attributes;
        attributes["POSITION"] = add_attribute(mesh, &Vertex::position, "VEC3");
        glm::vec3 low(std::numeric_limits<float>::max());
        glm::vec3 high(std::numeric_limits<float>::lowest());
        for (const Vertex& vertex : mesh.vertices) {
            low = glm::min(low, vertex.position);
            high = glm::max(high, vertex.position);
        }
        root_["accessors"].back()["min"] = numbers(low);
        root_["accessors"].back()["max"] = numbers(high);
        attributes["NORMAL"] = add_attribute(mesh, &Vertex::normal, "VEC3");
        attributes["TEXCOORD_0"] = add_attribute(mesh, &Vertex::texture_coordinates, "VEC2");
        attributes["COLOR_0"] = add_attribute(mesh, &Vertex::colour, "VEC4");
        const std::size_t indices = add_accessor(mesh.indices, "SCALAR", unsigned_int_component, index_target);
        const Json primitive = {{"attributes", attributes}, {"indices", indices}, {"material", mesh.material}};
        return {{"name", mesh.name}, {"primitives", Json::array({primitive})}};
    }

    void add_node(Json node, const glm::mat4& world_from_node) {
        if (world_from_node != glm::mat4(1.0f)) {
            node["matrix"] = numbers(glm::value_ptr(world_from_node), 16);
        }
        root_["scenes"][0]["nodes"].push_back(root_["nodes"].size());
        root_["nodes"].push_back(std::move(node));
    }

    void write_lamps() {
        for (const Lamp& lamp : scene_.lamps) {
            const float strength = std::max({lamp.intensity.r, lamp.intensity.g, lamp.intensity.b});
            Json light = {{"name", lamp.name},
                          {"type", "point"},
                          {"color", numbers(lamp.intensity / strength)},
                          {"intensity", strength}};
            if (lamp.range > 0.0f) {
                light["range"] = lamp.range;
            }
            if (lamp.spectrum && lamp.spectrum->black_body_kelvin()) {
                light["extras"]["rapidity"]["temperature_K"] = *lamp.spectrum->black_body_kelvin();
            }
            Json& lights = root_["extensions"]["KHR_lights_punctual"]["lights"];
            lights.push_back(std::move(light));
            const Json reference = {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}};
            glm::mat4 world_from_lamp(1.0f);
            world_from_lamp[3] = glm::vec4(lamp.position, 1.0f);
            add_node({{"name", lamp.name}, {"extensions", reference}}, world_from_lamp);
            extensions_.insert("KHR_lights_punctual");
        }
    }

    void write_cameras() {
        constexpr double aspect = 16.0 / 9.0;
        for (const StartView& view : scene_.start_views) {
            const double vertical = 2.0 * std::atan(std::tan(view.horizontal_field_of_view / 2.0) / aspect);
            const Json perspective = {{"yfov", vertical}, {"aspectRatio", aspect}, {"znear", 0.05}};
            root_["cameras"].push_back({{"name", view.name}, {"type", "perspective"}, {"perspective", perspective}});
            const glm::dvec3 right = glm::normalize(glm::cross(view.look, view.up));
            const glm::dvec3 up = glm::cross(right, view.look);
            const glm::dmat4 world_from_camera(glm::dvec4(right, 0.0), glm::dvec4(up, 0.0), glm::dvec4(-view.look, 0.0),
                                               glm::dvec4(view.position, 1.0));
            add_node({{"name", view.name}, {"camera", root_["cameras"].size() - 1}}, glm::mat4(world_from_camera));
        }
    }

    std::vector<std::uint8_t> file() const {
        std::string text = root_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::vector<std::uint8_t> bytes;
        const auto word = [&bytes](std::uint32_t value) {
            for (unsigned shift = 0; shift < 32; shift += 8) {
                bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xffU));
            }
        };
        constexpr std::uint32_t header_size = 12;
        constexpr std::uint32_t chunk_header_size = 8;
        const auto binary_size = static_cast<std::uint32_t>(binary_.size());
        const auto text_size = static_cast<std::uint32_t>(text.size());
        word(0x46546c67U); // "glTF"
        word(2);
        word(header_size + chunk_header_size + text_size + (binary_.empty() ? 0 : chunk_header_size + binary_size));
        word(text_size);
        word(0x4e4f534aU); // "JSON"
        bytes.insert(bytes.end(), text.begin(), text.end());
        if (!binary_.empty()) {
            word(binary_size);
            word(0x004e4942U); // "BIN"
            bytes.insert(bytes.end(), binary_.begin(), binary_.end());
        }
        return bytes;
    }

    const SceneDesc& scene_;
    Json root_;
    std::vector<std::uint8_t> binary_;
    std::set<std::string> extensions_;
};

} // namespace

std::vector<std::uint8_t> glb_bytes(const SceneDesc& scene) {
    return GlbWriter(scene).write();
}

} // namespace content::generator

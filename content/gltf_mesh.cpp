#include "content/gltf_mesh.h"

#include "content/gltf_accessor.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <numeric>
#include <optional>

namespace content {
namespace {

// One primitive on its way to a mesh.
class PrimitiveReader {
  public:
    PrimitiveReader(const GltfDocument& document, const tinygltf::Primitive& primitive, std::string field)
        : document_(document), primitive_(primitive), field_(std::move(field)) {}

    bool has_triangles() const {
        return primitive_.mode == TINYGLTF_MODE_TRIANGLES || primitive_.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
               primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    }

    bool has_positions() const { return primitive_.attributes.count("POSITION") != 0; }

    Mesh read(const GltfMaterials& materials) {
        Mesh mesh;
        mesh.material =
            primitive_.material < 0
                ? materials.materials.size() - 1
                : document_.checked_index(primitive_.material, materials.materials.size() - 1, field_ + ".material");
        const GltfNumbers positions =
            read_numbers(document_, primitive_.attributes.at("POSITION"), 3, 3, attribute_field("POSITION"));
        mesh.vertices.resize(positions.count);
        for (std::size_t i = 0; i < positions.count; ++i) {
            mesh.vertices[i].position = {positions.values[3 * i], positions.values[3 * i + 1],
                                         positions.values[3 * i + 2]};
        }
        mesh.indices = triangles(positions.count);
        read_colours(mesh);
        read_texture_coordinates(mesh, materials, mesh.material);
        if (!read_normals(mesh)) {
            make_flat(mesh);
        }
        return mesh;
    }

  private:
    std::string attribute_field(const std::string& name) const { return field_ + ".attributes." + name; }

    std::optional<GltfNumbers> attribute(const std::string& name, std::size_t fewest, std::size_t most,
                                         std::size_t vertices) const {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) {
            return std::nullopt;
        }
        GltfNumbers numbers = read_numbers(document_, found->second, fewest, most, attribute_field(name));
        if (numbers.count != vertices) {
            document_.fail(attribute_field(name), fmt::format("{} elements", numbers.count),
                           fmt::format("POSITION has {}", vertices));
        }
        return numbers;
    }

    std::vector<std::uint32_t> triangles(std::size_t vertices) const {
        std::vector<std::uint32_t> order;
        if (primitive_.indices >= 0) {
            order = read_indices(document_, primitive_.indices, vertices, field_ + ".indices");
        } else {
            order.resize(vertices);
            std::iota(order.begin(), order.end(), 0U);
        }
        const std::string counted = primitive_.indices >= 0 ? ".indices" : ".attributes.POSITION";
        if (primitive_.mode == TINYGLTF_MODE_TRIANGLES) {
            if (order.size() % 3 != 0) {
                document_.fail(field_ + counted, fmt::format("{} elements", order.size()),
                               "triangles need a multiple of 3");
            }
            return order;
        }
        if (order.size() < 3) {
            document_.fail(field_ + counted, fmt::format("{} elements", order.size()), "a triangle needs 3");
        }
        std::vector<std::uint32_t> unrolled;
        unrolled.reserve(3 * (order.size() - 2));
        for (std::size_t i = 0; i + 2 < order.size(); ++i) {
            // Every other triangle of a strip is wound the other way round (specification 3.7.2.1).
            const std::array<std::size_t, 3> corners =
                primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN
                    ? std::array<std::size_t, 3>{i + 1, i + 2, 0}
                    : std::array<std::size_t, 3>{i, i + 1 + i % 2, i + 2 - i % 2};
            for (const std::size_t corner : corners) {
                unrolled.push_back(order[corner]);
            }
        }
        return unrolled;
    }

    void read_colours(Mesh& mesh) const {
        const auto colours = attribute("COLOR_0", 3, 4, mesh.vertices.size());
        if (!colours) {
            return;
        }
        for (std::size_t i = 0; i < colours->count; ++i) {
            for (std::size_t c = 0; c < colours->components; ++c) {
                const float component = colours->values[i * colours->components + c];
                if (component < 0.0f) {
                    document_.fail(fmt::format("{}[{}]", attribute_field("COLOR_0"), i), fmt::format("{}", component),
                                   "a colour must not be negative");
                }
                mesh.vertices[i].colour[static_cast<glm::length_t>(c)] = std::min(component, 1.0f);
            }
        }
    }

    void read_texture_coordinates(Mesh& mesh, const GltfMaterials& materials, std::size_t material) const {
        const TextureMapping& mapping = materials.mappings[material];
        const auto coordinates =
            attribute(fmt::format("TEXCOORD_{}", mapping.coordinate_set), 2, 2, mesh.vertices.size());
        if (!coordinates) {
            return;
        }
        for (std::size_t i = 0; i < coordinates->count; ++i) {
            const glm::vec3 raw(coordinates->values[2 * i], coordinates->values[2 * i + 1], 1.0f);
            mesh.vertices[i].texture_coordinates = glm::vec2(mapping.transform * raw);
        }
    }

    bool read_normals(Mesh& mesh) const {
        const auto normals = attribute("NORMAL", 3, 3, mesh.vertices.size());
        if (!normals) {
            return false;
        }
        for (std::size_t i = 0; i < normals->count; ++i) {
            const glm::vec3 normal(normals->values[3 * i], normals->values[3 * i + 1], normals->values[3 * i + 2]);
            const float length = glm::length(normal);
            if (!(length > 0.0f) || length > 1e6f) {
                document_.fail(fmt::format("{}[{}]", attribute_field("NORMAL"), i),
                               fmt::format("({}, {}, {})", normal.x, normal.y, normal.z), "not a direction");
            }
            mesh.vertices[i].normal = normal / length;
        }
        return true;
    }

    // Three vertices of its own for each triangle: without normals a surface is flat (specification 3.7.2.1).
    static void make_flat(Mesh& mesh) {
        std::vector<Vertex> vertices;
        vertices.reserve(mesh.indices.size());
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            std::array<Vertex, 3> corners = {mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
                                             mesh.vertices[mesh.indices[i + 2]]};
            const glm::vec3 across =
                glm::cross(corners[1].position - corners[0].position, corners[2].position - corners[0].position);
            const float length = glm::length(across);
            for (Vertex& corner : corners) {
                // A triangle without area covers nothing, whatever its normal.
                corner.normal = length > 0.0f ? across / length : glm::vec3(0.0f, 1.0f, 0.0f);
                vertices.push_back(corner);
            }
        }
        mesh.vertices = std::move(vertices);
        std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
    }

    const GltfDocument& document_;
    const tinygltf::Primitive& primitive_;
    std::string field_;
};

} // namespace

std::vector<Mesh> read_mesh(const GltfDocument& document, std::size_t index, const GltfMaterials& materials,
                            std::vector<std::string>& notes) {
    const tinygltf::Mesh& source = document.model.meshes[index];
    const std::string mesh_field = fmt::format("meshes[{}]", index);
    std::vector<Mesh> meshes;
    for (std::size_t i = 0; i < source.primitives.size(); ++i) {
        const std::string field = fmt::format("{}.primitives[{}]", mesh_field, i);
        const tinygltf::Primitive& primitive = source.primitives[i];
        if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            document.fail(field + ".mode", std::to_string(primitive.mode), "must be in 0 to 6");
        }
        PrimitiveReader reader(document, primitive, field);
        if (!reader.has_triangles() || !reader.has_positions()) {
            notes.push_back(fmt::format("{} has no triangles and is not shown", field));
            continue;
        }
        if (!primitive.targets.empty()) {
            notes.push_back(fmt::format("{}: morph targets stay at rest", field));
        }
        meshes.push_back(reader.read(materials));
        meshes.back().name = source.name.empty() ? mesh_field : source.name;
    }
    return meshes;
}

} // namespace content

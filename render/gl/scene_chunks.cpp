#include "render/gl/scene_chunks.h"

#include "render/colour/frame_colour_table.h"
#include "render/falling_light.h"
#include "render/offline/scenery_hits.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace render {
namespace {

constexpr std::size_t triangles_per_chunk = 128;
constexpr std::size_t most_lamps_per_chunk = 255;

struct WorldTriangle {
    std::array<content::Vertex, 3> vertices; ///< world space
    std::uint32_t material = 0;
    std::uint32_t object = 0;

    glm::vec3 centre() const { return (vertices[0].position + vertices[1].position + vertices[2].position) / 3.0f; }
};

using Triangles = std::span<WorldTriangle>;

Box box_of(Triangles triangles) {
    Box box{triangles.front().vertices[0].position, triangles.front().vertices[0].position};
    for (const WorldTriangle& triangle : triangles) {
        for (const content::Vertex& vertex : triangle.vertices) {
            box.low = glm::min(box.low, vertex.position);
            box.high = glm::max(box.high, vertex.position);
        }
    }
    return box;
}

float distance_to_box(const Box& box, const glm::vec3& point) {
    return glm::length(glm::max(glm::max(box.low - point, point - box.high), glm::vec3(0.0f)));
}

std::vector<ImageArray> group_images(const content::SceneDesc& scene,
                                     std::vector<std::pair<int, std::uint32_t>>& array_and_layer) {
    std::vector<ImageArray> arrays;
    for (std::size_t i = 0; i < scene.images.size(); ++i) {
        const content::Image& image = scene.images[i];
        auto array = std::find_if(arrays.begin(), arrays.end(), [&](const ImageArray& a) {
            return a.width == image.width && a.height == image.height;
        });
        if (array == arrays.end()) {
            array = arrays.insert(arrays.end(), ImageArray{image.width, image.height, {}});
        }
        array_and_layer.emplace_back(static_cast<int>(array - arrays.begin()),
                                     static_cast<std::uint32_t>(array->images.size()));
        array->images.push_back(i);
    }
    return arrays;
}

void place_instance(const content::SceneDesc& scene, std::size_t object, std::vector<WorldTriangle>& triangles) {
    const content::Instance& instance = scene.instances[object];
    const content::Mesh& mesh = scene.meshes[instance.mesh];
    const glm::mat3 linear(instance.world_from_mesh);
    const glm::mat3 normal_matrix = glm::inverseTranspose(linear);
    const bool mirrored = glm::determinant(linear) < 0.0f;
    const bool double_sided = scene.materials[mesh.material].double_sided;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        WorldTriangle triangle;
        triangle.material = static_cast<std::uint32_t>(mesh.material);
        triangle.object = static_cast<std::uint32_t>(object);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            content::Vertex vertex = mesh.vertices[mesh.indices[i + corner]];
            vertex.position = glm::vec3(instance.world_from_mesh * glm::vec4(vertex.position, 1.0f));
            const glm::vec3 normal = normal_matrix * vertex.normal;
            const float length = glm::length(normal);
            vertex.normal = length > 0.0f ? normal / length : glm::vec3(0.0f, 1.0f, 0.0f);
            triangle.vertices[corner] = vertex;
        }
        if (mirrored) {
            std::swap(triangle.vertices[1], triangle.vertices[2]);
        }
        const auto& [a, b, c] = triangle.vertices;
        if (glm::cross(b.position - a.position, c.position - a.position) == glm::vec3(0.0f)) {
            continue;
        }
        triangles.push_back(triangle);
        if (double_sided) {
            std::swap(triangle.vertices[1], triangle.vertices[2]);
            for (content::Vertex& vertex : triangle.vertices) {
                vertex.normal = -vertex.normal;
            }
            triangles.push_back(triangle);
        }
    }
}

/// Irradiance / pi that a lamp gives to a surface (the light model's formula).
glm::vec3 lamp_light(const content::Lamp& lamp, const glm::vec3& position, const glm::vec3& normal) {
    const float share = shared::lamp_share(lamp.position - position, normal, lamp.range);
    return std::numbers::inv_pi_v<float> * share * lamp.intensity;
}

std::uint16_t unorm16(float value) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535.0f));
}

/// Cuts the triangles of one kind into chunks and appends them with their vertices.
class ChunkBuilder {
  public:
    ChunkBuilder(const content::SceneDesc& scene, const SceneSpectra& spectra, ChunkedScene& result)
        : scene_(scene), spectra_(spectra), result_(result) {}

    void add(Triangles triangles, const ChunkKind& kind) {
        const Box box = box_of(triangles);
        if (triangles.size() <= triangles_per_chunk) {
            add_chunk(triangles, box, kind);
            return;
        }
        const glm::vec3 extent = box.high - box.low;
        const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const std::size_t half = triangles.size() / 2;
        std::nth_element(
            triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
            [axis](const WorldTriangle& a, const WorldTriangle& b) { return a.centre()[axis] < b.centre()[axis]; });
        add(triangles.first(half), kind);
        add(triangles.subspan(half), kind);
    }

  private:
    struct LampChoice {
        std::vector<std::size_t> at_vertices;
        std::uint32_t per_fragment = 0; ///< packed as in SceneVertex::lamps
    };

    LampChoice choose_lamps(Triangles triangles, const Box& box) {
        float longest_edge = 0.0f;
        for (const WorldTriangle& t : triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
                longest_edge =
                    std::max(longest_edge, glm::distance(t.vertices[i].position, t.vertices[(i + 1) % 3].position));
            }
        }
        LampChoice choice;
        const auto first = static_cast<std::uint32_t>(result_.lamp_indices.size());
        std::uint32_t count = 0;
        for (std::size_t i = 0; i < scene_.lamps.size(); ++i) {
            const content::Lamp& lamp = scene_.lamps[i];
            const float distance = distance_to_box(box, lamp.position);
            if (lamp.range > 0.0f && distance >= lamp.range) {
                continue;
            }
            // Between vertices a fifth of the distance apart, linear interpolation of cos/d^2 errs by about
            // (1/5)^2 * 6/8 = 3 % of a light that has fallen to a small part of its neighbourhood's.
            const bool scene_light = spectra_.lamps()[i] == 0; // vertices carry light of one spectrum
            if ((longest_edge < 0.2f * distance && scene_light) || count == most_lamps_per_chunk) {
                choice.at_vertices.push_back(i);
            } else {
                result_.lamp_indices.push_back(static_cast<std::uint32_t>(i));
                ++count;
            }
        }
        choice.per_fragment = first * 256u + count;
        return choice;
    }

    void add_chunk(Triangles triangles, const Box& box, ChunkKind kind) {
        const LampChoice lamps = kind.unlit ? LampChoice{} : choose_lamps(triangles, box);
        kind.near_lamps = (lamps.per_fragment & 255u) != 0;
        Chunk chunk;
        chunk.box = box;
        chunk.kind = index_of(kind);
        chunk.first_index = static_cast<std::uint32_t>(result_.indices.size());
        chunk.index_count = static_cast<std::uint32_t>(triangles.size() * 3);
        std::map<std::array<float, 12>, std::uint32_t> known;
        for (const WorldTriangle& triangle : triangles) {
            for (const content::Vertex& v : triangle.vertices) {
                const std::array<float, 12> key{v.position.x,
                                                v.position.y,
                                                v.position.z,
                                                v.normal.x,
                                                v.normal.y,
                                                v.normal.z,
                                                v.texture_coordinates.x,
                                                v.texture_coordinates.y,
                                                v.colour.r,
                                                v.colour.g,
                                                v.colour.b,
                                                static_cast<float>(triangle.object)};
                const auto [entry, fresh] = known.try_emplace(key, static_cast<std::uint32_t>(result_.vertices.size()));
                if (fresh) {
                    result_.vertices.push_back(vertex_of(triangle, v, lamps));
                }
                result_.indices.push_back(entry->second);
            }
        }
        result_.chunks.push_back(chunk);
    }

    SceneVertex vertex_of(const WorldTriangle& triangle, const content::Vertex& v, const LampChoice& lamps) const {
        const glm::vec4 colour = scene_.materials[triangle.material].base_colour * v.colour;
        glm::vec3 light = scene_.ambient * shared::ambient_share(v.normal.y);
        for (const std::size_t lamp : lamps.at_vertices) {
            const glm::vec3 of_lamp = lamp_light(scene_.lamps[lamp], v.position, v.normal);
            if (of_lamp != glm::vec3(0.0f) && lamp_visible(scene_.lamps[lamp], v)) {
                light += of_lamp;
            }
        }
        SceneVertex result;
        result.position = v.position;
        result.normal = glm::packSnorm3x10_1x2(glm::vec4(v.normal, 0.0f));
        result.texture_coordinates = v.texture_coordinates;
        result.colour = {unorm16(colour.r), unorm16(colour.g), unorm16(colour.b), unorm16(colour.a)};
        result.light = {glm::packHalf1x16(light.r), glm::packHalf1x16(light.g), glm::packHalf1x16(light.b), 0};
        result.material = triangle.material;
        result.lamps = lamps.per_fragment;
        result.object = triangle.object;
        return result;
    }

    bool lamp_visible(const content::Lamp& lamp, const content::Vertex& v) const {
        if (!scenery_) {
            scenery_.emplace(scene_);
        }
        // Vertices lie on edges, where several surfaces meet: look from a little way off.
        constexpr double off_surface = 0.02; // metres
        const glm::dvec3 origin = glm::dvec3(v.position) + off_surface * glm::dvec3(v.normal);
        const glm::dvec3 offset = glm::dvec3(lamp.position) - origin;
        const double distance = glm::length(offset);
        return distance <= content::lamp_clearance ||
               !scenery_->blocked(origin, offset / distance, distance - content::lamp_clearance);
    }

    std::size_t index_of(const ChunkKind& kind) {
        auto found = std::find(result_.kinds.begin(), result_.kinds.end(), kind);
        if (found == result_.kinds.end()) {
            found = result_.kinds.insert(found, kind);
        }
        return static_cast<std::size_t>(found - result_.kinds.begin());
    }

    const content::SceneDesc& scene_;
    const SceneSpectra& spectra_;
    ChunkedScene& result_;
    mutable std::optional<SceneryHits> scenery_; ///< made when a lamp needs it
};

/// Appends the tree over `chunks` and returns its root.
std::uint32_t build_tree(const ChunkedScene& scene, std::span<std::int32_t> chunks, std::vector<ChunkNode>& nodes) {
    const auto box_at = [&](std::int32_t i) { return scene.chunks[static_cast<std::size_t>(i)].box; };
    ChunkNode node{box_at(chunks.front())};
    for (const std::int32_t i : chunks) {
        node.box.low = glm::min(node.box.low, box_at(i).low);
        node.box.high = glm::max(node.box.high, box_at(i).high);
    }
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(node);
    if (chunks.size() == 1) {
        nodes[index].chunk = chunks.front();
        return index;
    }
    const glm::vec3 extent = node.box.high - node.box.low;
    const glm::length_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
    const std::size_t half = chunks.size() / 2;
    std::nth_element(chunks.begin(), chunks.begin() + static_cast<std::ptrdiff_t>(half), chunks.end(),
                     [&](std::int32_t a, std::int32_t b) {
                         return box_at(a).low[axis] + box_at(a).high[axis] < box_at(b).low[axis] + box_at(b).high[axis];
                     });
    const std::uint32_t left = build_tree(scene, chunks.first(half), nodes);
    const std::uint32_t right = build_tree(scene, chunks.subspan(half), nodes);
    nodes[index].left = left;
    nodes[index].right = right;
    return index;
}

/// Where an image lies among the arrays.
struct ImagePlaces {
    std::vector<std::pair<int, std::uint32_t>> array_and_layer;

    int array(const std::optional<std::size_t>& image) const { return image ? array_and_layer[*image].first : -1; }
    std::uint32_t layer(const std::optional<std::size_t>& image) const {
        return image ? array_and_layer[*image].second : 0u;
    }
};

GpuMaterial gpu_material(const content::Material& material, const MaterialTerms& terms, const ImagePlaces& places,
                         const FrameColourTable& table) {
    GpuMaterial result;
    result.emission = glm::vec4(material.emission, material.alpha_cutoff);
    result.base_colour_layer = places.layer(material.base_colour_image);
    result.emission_layer = places.layer(material.emission_image);
    result.reflected_layer = static_cast<std::uint32_t>(table.first_layer[terms.reflected]);
    result.emitted_layer = static_cast<std::uint32_t>(table.first_layer[terms.emitted]);
    result.invisible = invisible_bands(terms);
    return result;
}

ChunkKind kind_of(const content::Material& material, const MaterialTerms& terms, const SceneSpectra& spectra,
                  const ImagePlaces& places) {
    ChunkKind kind;
    kind.base_colour_array = places.array(material.base_colour_image);
    kind.emission_array = places.array(material.emission_image);
    kind.masked = material.alpha_mode == content::AlphaMode::mask;
    kind.unlit = material.unlit;
    kind.emits = content::emits(material);
    if (!material.unlit) {
        const SurfaceSpectrum& surface = spectra.surfaces()[terms.surface];
        kind.rule = surface.rule;
        kind.invisible = surface.invisible();
        kind.layers = layers_of(surface);
        const SurfaceSpectrum& emitted = spectra.surfaces()[spectra.groups()[terms.emitted].surface];
        kind.emission_spectrum = emitted.rule == content::ReflectanceRule::own;
        kind.emission_invisible = emitted.invisible();
    }
    return kind;
}

} // namespace

ChunkedScene chunk_scene(const content::SceneDesc& scene, const SceneSpectra& spectra) {
    ChunkedScene result;
    ImagePlaces places;
    result.image_arrays = group_images(scene, places.array_and_layer);
    const FrameColourTable table(spectra);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        result.materials.push_back(gpu_material(scene.materials[i], spectra.materials()[i], places, table));
    }

    std::vector<WorldTriangle> triangles;
    for (std::size_t object = 0; object < scene.instances.size(); ++object) {
        place_instance(scene, object, triangles);
    }
    std::vector<std::pair<ChunkKind, std::vector<WorldTriangle>>> by_kind;
    for (const WorldTriangle& triangle : triangles) {
        const ChunkKind kind =
            kind_of(scene.materials[triangle.material], spectra.materials()[triangle.material], spectra, places);
        auto found =
            std::find_if(by_kind.begin(), by_kind.end(), [&](const auto& entry) { return entry.first == kind; });
        if (found == by_kind.end()) {
            found = by_kind.insert(found, {kind, {}});
        }
        found->second.push_back(triangle);
    }
    ChunkBuilder builder(scene, spectra, result);
    for (auto& [kind, members] : by_kind) {
        builder.add(members, kind);
    }
    if (!result.chunks.empty()) {
        std::vector<std::int32_t> order(result.chunks.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = static_cast<std::int32_t>(i);
        }
        result.nodes.reserve(2 * order.size());
        build_tree(result, order, result.nodes);
    }
    return result;
}

} // namespace render

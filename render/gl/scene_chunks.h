#pragma once

#include "content/scene_desc.h"
#include "render/colour/scene_spectra.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

/// A scene cut into small compact pieces in world space: plain data, ready for upload. No OpenGL.
namespace render {

/// A vertex as the GPU reads it; attribute formats in SceneBuffers.
struct SceneVertex {
    glm::vec3 position{0.0f}; ///< scene metres, world
    std::uint32_t normal = 0; ///< GL_INT_2_10_10_10_REV, world
    glm::vec2 texture_coordinates{0.0f};
    std::array<std::uint16_t, 4> colour{}; ///< unorm: vertex colour times base colour
    std::array<std::uint16_t, 4> light{};  ///< half floats: light that varies slowly (sky light, lamps far away)
    std::uint32_t material = 0;
    std::uint32_t lamps = 0; ///< first entry in ChunkedScene::lamp_indices * 256 + number of entries
    std::uint32_t object = 0;
};

/// What decides the program and the textures that draw a chunk.
struct ChunkKind {
    int base_colour_array = -1; ///< index into ChunkedScene::image_arrays; -1: no texture
    int emission_array = -1;
    bool masked = false;
    bool unlit = false;
    bool near_lamps = false; ///< lit by lamps that need evaluation for every fragment
    content::ReflectanceRule rule = content::ReflectanceRule::three_primaries;
    bool invisible = false; ///< reflectances of its own in the ultraviolet or infrared
    int layers = 0;         ///< in the frame's colour table, of what is reflected of each light
    bool emits = false;
    bool emission_spectrum = false;  ///< of its own
    bool emission_invisible = false; ///< in the ultraviolet or infrared

    friend bool operator==(const ChunkKind&, const ChunkKind&) = default;
};

struct Box {
    glm::vec3 low{0.0f};
    glm::vec3 high{0.0f};
};

/// About a hundred neighbouring triangles of one kind: one entry of a multi-draw.
struct Chunk {
    Box box;
    std::size_t kind = 0;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

/// A node of the tree over all chunks. Leaves have `chunk` >= 0; the children of others are stored after them.
struct ChunkNode {
    Box box;
    std::int32_t chunk = -1;
    std::uint32_t left = 0;
    std::uint32_t right = 0;
};

/// Images of one size, layers of one array texture.
struct ImageArray {
    int width = 0;
    int height = 0;
    std::vector<std::size_t> images; ///< into SceneDesc::images, one a layer
};

/// What fragments need to know of a material; std430 layout.
struct GpuMaterial {
    glm::vec4 emission{0.0f}; ///< w: alpha cutoff
    std::uint32_t base_colour_layer = 0;
    std::uint32_t emission_layer = 0;
    std::uint32_t reflected_layer = 0; ///< in the frame's colour table: of what is reflected of the first light,
    std::uint32_t emitted_layer = 0;   ///< of what is emitted
    glm::vec4 invisible{0.0f};         ///< ultraviolet and infrared: reflectance, emission
};

struct ChunkedScene {
    std::vector<SceneVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<ChunkKind> kinds;
    std::vector<Chunk> chunks;
    std::vector<ChunkNode> nodes; ///< empty when the scene has no triangles; the root is the first
    std::vector<ImageArray> image_arrays;
    std::vector<GpuMaterial> materials;
    std::vector<std::uint32_t> lamp_indices; ///< into SceneDesc::lamps
};

/// Places all instances in the world, turns double-sided triangles into two, sorts by kind, cuts into chunks and
/// evaluates the slowly varying light at the vertices, shadows of far lamps included. Triangles without area are left
/// out.
ChunkedScene chunk_scene(const content::SceneDesc& scene, const SceneSpectra& spectra);

} // namespace render

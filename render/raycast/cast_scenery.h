#pragma once

#include "content/scene_desc.h"
#include "render/colour/scene_spectra.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace render {

/// What shading needs of a triangle besides the hit itself: one cache line. Texture coordinates are linear in the
/// barycentric u and v; their gradients along the triangle's plane, per metre in the world, tell how fine a texture
/// lies.
struct alignas(64) CastTriangle {
    glm::vec2 texture_coordinates{0.0f}; ///< at the first vertex
    glm::vec2 along_u{0.0f};             ///< from it to the second
    glm::vec2 along_v{0.0f};             ///< from it to the third
    glm::vec3 gradient_s{0.0f};
    glm::vec3 gradient_t{0.0f};
    std::uint32_t material = 0; ///< into CastScenery::materials
    std::uint32_t corners = 0;  ///< into CastScenery::corners; the first is the one of flat triangles without colours
};

/// Vertex normals in the world and colours, for triangles where they matter.
struct CastCorners {
    std::array<glm::vec3, 3> normals{}; ///< first vertex, and the differences of the second and third from it
    std::array<glm::vec3, 3> colours{glm::vec3(1.0f), glm::vec3(0.0f), glm::vec3(0.0f)}; ///< likewise
};

struct CastMaterial {
    glm::vec3 base_colour{1.0f};
    glm::vec3 emission{0.0f};
    std::int32_t base_colour_image = -1;
    std::int32_t emission_image = -1;
    bool unlit = false;
    bool emits = false;
    content::ReflectanceRule rule = content::ReflectanceRule::three_primaries;
    bool invisible = false;         ///< has reflectances of its own in the invisible,
    int first_invisible = 0;        ///< terms of this index and the next,
    bool emission_spectrum = false; ///< of its own
    bool emission_invisible = false;
    int reflected_layer = 0;         ///< in the frame's colour table: of what is reflected of the first light,
    int next_light = 0;              ///< layers from one light to the next,
    int emitted_layer = 0;           ///< and of what is emitted
    glm::vec4 invisible_bands{0.0f}; ///< ultraviolet and infrared: reflectance, emission
};

/// A scene's surfaces laid out for ray-cast shading: 64 bytes a triangle, 72 more where normals or colours vary over
/// it.
struct CastScenery {
    CastScenery(const content::SceneDesc& scene, const SceneSpectra& spectra);

    std::vector<std::uint32_t> first_triangle; ///< of each instance
    std::vector<CastTriangle> triangles;
    std::vector<CastCorners> corners;
    std::vector<CastMaterial> materials;
};

} // namespace render

#include "content/generator/models.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

namespace content::generator {
namespace {

constexpr float half_width = 7.0f;
constexpr float height = 9.0f;
constexpr float bay = 10.0f;
constexpr int bays = 30;

// Square tiles with joints between them, shades alternating as on a chessboard; `tiles` a picture and direction.
glm::vec3 tile_colour(const glm::vec2& point, int tiles, std::uint32_t light, std::uint32_t dark, std::uint32_t seed) {
    const glm::vec2 p = point * static_cast<float>(tiles);
    const glm::ivec2 tile(glm::floor(p));
    const glm::vec2 in_tile = glm::fract(p);
    const float texel = static_cast<float>(tiles) / 512.0f;
    glm::vec3 colour = encoded((tile.x + tile.y) % 2 == 0 ? light : dark);
    colour *= 0.92f + 0.12f * random_at(tile.x, tile.y, seed);
    colour *= 0.93f + 0.14f * clouds(point, {8, 8}, 4, seed + 1);
    const float inside = box_distance(in_tile, glm::vec2(0.5f), glm::vec2(0.478f), 0.03f);
    const float bevel = box_distance(in_tile, glm::vec2(0.5f), glm::vec2(0.44f), 0.03f);
    colour *= 1.0f + 0.10f * coverage(std::abs(bevel) - 0.012f, texel);
    return glm::mix(encoded(0x2b2724), colour, coverage(inside, texel));
}

glm::vec3 rib_colour(const glm::vec2& point) {
    const glm::vec3 colour = encoded(0xcfc7b8) * (0.9f + 0.14f * clouds(point, {8, 8}, 4, 71));
    const glm::vec2 folded = glm::abs(glm::fract(point * 2.0f) - 0.5f);
    const float rivet = disk_distance(folded, {0.36f, 0.36f}, 0.05f);
    return glm::mix(colour, encoded(0x6d675d), 0.8f * coverage(rivet, 4.0f / 256.0f));
}

// The end of the box: rings, so that its apparent size can be followed.
glm::vec3 target_colour(const glm::vec2& point) {
    const glm::vec2 p = (point - 0.5f) * glm::vec2(2.0f * half_width, height);
    const float radius = glm::length(p);
    constexpr float texel = 2.0f * half_width / 1024.0f;
    glm::vec3 colour = encoded(0x23404a) * (0.9f + 0.15f * clouds(point, {12, 8}, 4, 91));
    for (int ring = 4; ring >= 0; --ring) {
        const float edge = 0.8f + 0.8f * static_cast<float>(ring);
        const glm::vec3 paint_colour = ring % 2 == 0 ? encoded(0xd8572a) : encoded(0xf2e8d5);
        colour = glm::mix(colour, paint_colour, coverage(radius - edge, texel));
    }
    const float cross = std::min(std::abs(p.x), std::abs(p.y)) - 0.03f;
    return glm::mix(colour, encoded(0x23282b), 0.8f * coverage(cross, texel));
}

// Corners where two walls meet see less of the room's light.
float corner_shade(const glm::vec3& position, const glm::vec3& normal) {
    const auto shade = [](float distance) { return 0.45f + 0.55f * glm::smoothstep(0.0f, 1.8f, distance); };
    const float across = std::abs(normal.x) > 0.5f ? 1.0f : shade(half_width - std::abs(position.x));
    const float upward = std::abs(normal.y) > 0.5f ? 1.0f : shade(std::min(position.y, height - position.y));
    return across * upward;
}

// One wall of a bay, in strips that are narrow towards the corners, where the shade changes.
void wall(MeshBuilder& builder, const glm::vec3& corner, const glm::vec3& across, const glm::vec3& along) {
    const float width = glm::length(across);
    const std::array<float, 6> cuts = {0.0f, 0.6f / width, 1.8f / width, 1.0f - 1.8f / width, 1.0f - 0.6f / width,
                                       1.0f};
    constexpr int lengths = 2;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        for (int j = 0; j < lengths; ++j) {
            const glm::vec3 near = along * (static_cast<float>(j) / lengths);
            const glm::vec3 far = along * (static_cast<float>(j + 1) / lengths);
            builder.quad({{corner + across * cuts[i] + near, corner + across * cuts[i + 1] + near,
                           corner + across * cuts[i + 1] + far, corner + across * cuts[i] + far}});
        }
    }
}

MeshBuilder wall_builder() {
    MeshBuilder builder;
    builder.texture_size = bay / 2.0f;
    builder.shade = corner_shade;
    return builder;
}

// A frame around the box at the start of a bay.
MeshBuilder rib() {
    MeshBuilder builder;
    builder.texture_size = 2.0f;
    constexpr float depth = 0.55f;
    constexpr float half_length = 0.4f;
    for (const float side : {-1.0f, 1.0f}) {
        const float outer = side * half_width;
        const float inner = side * (half_width - depth);
        builder.box({std::min(outer, inner), 0.0f, -half_length}, {std::max(outer, inner), height, half_length},
                    face_front | face_back | (side < 0.0f ? face_right : face_left));
    }
    constexpr float inner = half_width - depth;
    builder.box({-inner, height - depth, -half_length}, {inner, height, half_length},
                face_front | face_back | face_bottom);
    builder.box({-inner, 0.0f, -half_length}, {inner, 0.12f, half_length}, face_front | face_back | face_top);
    return builder;
}

// Two strips of light under the ceiling.
MeshBuilder strips() {
    MeshBuilder builder;
    for (const float x : {-3.2f, 3.2f}) {
        builder.box({x - 0.22f, height - 0.14f, -bay + 1.6f}, {x + 0.22f, height, -1.6f}, all_faces & ~face_top);
    }
    return builder;
}

struct CorridorMaterials {
    std::size_t floor;
    std::size_t left;
    std::size_t right;
    std::size_t ceiling;
    std::size_t rib;
    std::size_t glow;
    std::size_t end;
};

CorridorMaterials add_materials(SceneDesc& scene) {
    const auto tiles = [&](const char* name, int count, std::uint32_t light, std::uint32_t dark, std::uint32_t seed) {
        return add_painted_material(scene, paint(name, 512, 512, [=](const glm::vec2& point) {
                                        return tile_colour(point, count, light, dark, seed);
                                    }));
    };
    return {.floor = tiles("floor tiles", 4, 0xb9a58a, 0x6b5a4a, 31),
            .left = tiles("teal tiles", 4, 0x8fb8b2, 0x4f8584, 37),
            .right = tiles("ochre tiles", 4, 0xe0b878, 0xb9834a, 41),
            .ceiling = tiles("ceiling panels", 2, 0xd9d6cf, 0xcbc7be, 43),
            .rib = add_painted_material(scene, paint("rib", 256, 256, rib_colour)),
            .glow = add_glowing_material(scene, "light strip", glm::vec3(3.2f, 2.8f, 2.3f)),
            .end = add_painted_material(scene, paint("target", 1024, 660, target_colour))};
}

void place_bays(SceneDesc& scene, const CorridorMaterials& materials) {
    constexpr float w = half_width;
    const std::array names = {"floor", "left wall", "right wall", "ceiling"};
    std::array<MeshBuilder, 4> walls = {wall_builder(), wall_builder(), wall_builder(), wall_builder()};
    const glm::vec3 along{0.0f, 0.0f, -bay};
    wall(walls[0], {-w, 0.0f, 0.0f}, {2.0f * w, 0.0f, 0.0f}, along);
    wall(walls[1], {-w, height, 0.0f}, {0.0f, -height, 0.0f}, along);
    wall(walls[2], {w, 0.0f, 0.0f}, {0.0f, height, 0.0f}, along);
    wall(walls[3], {w, height, 0.0f}, {-2.0f * w, 0.0f, 0.0f}, along);
    const std::array wall_materials = {materials.floor, materials.left, materials.right, materials.ceiling};
    std::array<std::size_t, 4> meshes{};
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        meshes[i] = add_mesh(scene, walls[i].mesh(names[i], wall_materials[i]));
    }
    const std::size_t rib_mesh = add_mesh(scene, rib().mesh("rib", materials.rib));
    const std::size_t strip_mesh = add_mesh(scene, strips().mesh("light strips", materials.glow));
    for (int i = 0; i < bays; ++i) {
        const glm::mat4 here = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -bay * static_cast<float>(i)));
        for (std::size_t j = 0; j < meshes.size(); ++j) {
            place(scene, fmt::format("{} {}", names[j], i), meshes[j], here);
        }
        place(scene, fmt::format("rib {}", i), rib_mesh, here);
        place(scene, fmt::format("light strips {}", i), strip_mesh, here);
    }
}

void place_ends(SceneDesc& scene, std::size_t material) {
    constexpr float far = -bay * static_cast<float>(bays);
    constexpr float w = half_width;
    MeshBuilder end;
    end.quad({{{-w, 0.0f, far}, {w, 0.0f, far}, {w, height, far}, {-w, height, far}}}, TextureArea{});
    place(scene, "end wall", end, material);
    MeshBuilder start;
    start.quad({{{w, 0.0f, 0.0f}, {-w, 0.0f, 0.0f}, {-w, height, 0.0f}, {w, height, 0.0f}}}, TextureArea{});
    place(scene, "start wall", start, material);
}

void add_lamps(SceneDesc& scene) {
    constexpr int bays_a_lamp = 2;
    for (int i = 0; i < bays; i += bays_a_lamp) {
        const float z = -bay * (static_cast<float>(i) + 0.5f);
        scene.lamps.push_back({fmt::format("lamp {}", i), {0.0f, height - 1.2f, z}, {34.0f, 29.0f, 22.0f}, 45.0f});
    }
}

} // namespace

SceneDesc corridor() {
    SceneDesc scene;
    const CorridorMaterials materials = add_materials(scene);
    place_bays(scene, materials);
    place_ends(scene, materials.end);
    add_lamps(scene);
    return scene;
}

} // namespace content::generator

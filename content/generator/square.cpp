#include "content/generator/models.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/square_parts.h"
#include "content/generator/surface_paint.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

namespace content::generator {
namespace {

constexpr float square_radius = 24.0f;
constexpr float terrace_radius = 60.0f;

glm::vec3 cobble_colour(const glm::vec2& point) {
    const glm::vec2 p = point * glm::vec2(10.0f, 12.0f);
    const float row = std::floor(p.y);
    const glm::vec2 stone{p.x + 0.5f * std::fmod(row, 2.0f), p.y};
    const float shade = random_at(static_cast<int>(std::floor(stone.x)) % 10, static_cast<int>(row), 211);
    const float face = (0.72f + 0.24f * shade) * (0.9f + 0.14f * clouds(point, {10, 10}, 4, 213));
    const float inside = box_distance(glm::fract(stone), glm::vec2(0.5f), glm::vec2(0.455f), 0.14f);
    return glm::vec3(glm::mix(0.42f, face, coverage(inside, 12.0f / 512.0f)));
}

glm::vec3 wood_colour(const glm::vec2& point) {
    const float grain = clouds(point, {4, 40}, 4, 223);
    return glm::mix(encoded(0x7a5230), encoded(0xb5844f), grain);
}

glm::vec3 hedge_colour(const glm::vec2& point) {
    const float leaves = clouds(point, {18, 18}, 4, 227);
    return glm::mix(encoded(0x24381c), encoded(0x6f8a42), glm::smoothstep(0.3f, 0.75f, leaves));
}

glm::vec3 water_colour(const glm::vec2& point) {
    const float waves = clouds(point, {6, 6}, 4, 229);
    return glm::mix(encoded(0x2f6a72), encoded(0x9fc4c4), glm::smoothstep(0.35f, 0.8f, waves));
}

SquareMaterials add_materials(SceneDesc& scene) {
    const std::size_t hedge = add_painted_material(scene, paint("hedge", 256, 256, hedge_colour));
    scene.materials[hedge].vegetation = true;
    return {.cobbles = add_painted_material(scene, paint("cobbles", 512, 512, cobble_colour)),
            .stone = add_painted_material(scene, stone_image()),
            .wood = add_painted_material(scene, paint("wood", 256, 256, wood_colour)),
            .hedge = hedge,
            .water = add_painted_material(scene, paint("water", 256, 256, water_colour)),
            .bronze = add_plain_material(scene, "bronze"),
            .tree = add_tree_materials(scene),
            .metal = add_plain_material(scene, "cast iron", linear(0x3a4240)),
            .lantern = add_glowing_material(scene, "lantern", glm::vec3(3.2f, 2.3f, 1.3f))};
}

// Rings of paving from the fountain's foot to the terrace's edge.
void add_paving(SceneDesc& scene, const SquareMaterials& materials) {
    struct Band {
        float outer;
        float inner;
        std::uint32_t tint;
    };
    constexpr std::array<Band, 8> bands = {{{terrace_radius, 44.0f, 0xa29a8c},
                                            {44.0f, 34.0f, 0xa29a8c},
                                            {34.0f, square_radius, 0xb0a594},
                                            {square_radius, 22.8f, 0xe6dac2},
                                            {22.8f, 15.6f, 0xb98f72},
                                            {15.6f, 14.6f, 0xe6dac2},
                                            {14.6f, 7.2f, 0xc7a888},
                                            {7.2f, 5.9f, 0xe6dac2}}};
    for (std::size_t i = 0; i < bands.size(); ++i) {
        MeshBuilder band;
        band.texture_size = 2.0f;
        band.tint = linear(bands[i].tint);
        band.shade = [](const glm::vec3& position, const glm::vec3&) {
            return 0.6f + 0.4f * glm::smoothstep(5.9f, 7.4f, glm::length(position));
        };
        const float middle = 0.5f * (bands[i].outer + bands[i].inner);
        band.turn(std::array<ProfilePoint, 3>{{{bands[i].outer, 0.0f}, {middle, 0.0f}, {bands[i].inner, 0.0f}}}, 64);
        place(scene, fmt::format("paving ring {}", i), band, materials.cobbles);
    }
}

// A place on a circle about the middle; local +z points to the middle.
glm::mat4 on_circle(float radius, float angle) {
    return glm::translate(glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 1.0f, 0.0f)),
                          glm::vec3(0.0f, 0.0f, -radius));
}

// The low wall around the terrace, a balustrade's height, with a pier every 15 degrees.
void add_parapet(SceneDesc& scene, const SquareMaterials& materials) {
    MeshBuilder wall;
    wall.texture_size = 2.0f;
    wall.tint = linear(0xcabb9f);
    constexpr float r = terrace_radius;
    wall.turn(
        std::array<ProfilePoint, 6>{
            {{r, -4.0f}, {r, 1.0f}, {r + 0.1f, 1.0f}, {r + 0.1f, 1.15f}, {r - 0.55f, 1.15f}, {r - 0.55f, 1.0f}}},
        72);
    wall.turn(std::array<ProfilePoint, 2>{{{r - 0.45f, 1.0f}, {r - 0.45f, 0.0f}}}, 72);
    place(scene, "parapet", wall, materials.stone);
    MeshBuilder pier;
    pier.texture_size = 2.0f;
    pier.tint = linear(0xd9cbb0);
    pier.box({-0.5f, 0.0f, -0.5f}, {0.5f, 1.45f, 0.5f}, all_but_bottom);
    pier.box({-0.6f, 1.45f, -0.6f}, {0.6f, 1.6f, 0.6f});
    pier.ball({0.0f, 1.95f, 0.0f}, 1, [](const glm::vec3&) { return 0.38f; });
    const std::size_t pier_mesh = add_mesh(scene, pier.mesh("parapet pier", materials.stone));
    for (int i = 0; i < 24; ++i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / 24.0f;
        place(scene, fmt::format("parapet pier {}", i), pier_mesh, on_circle(r - 0.22f, angle));
    }
}

MeshBuilder bench_planks() {
    MeshBuilder builder;
    builder.texture_size = 1.5f;
    for (int i = 0; i < 4; ++i) {
        const float z = -0.22f + 0.13f * static_cast<float>(i);
        builder.box({-0.9f, 0.44f, z}, {0.9f, 0.48f, z + 0.11f});
    }
    for (int i = 0; i < 3; ++i) {
        const float y = 0.58f + 0.14f * static_cast<float>(i);
        builder.box({-0.9f, y, -0.32f}, {0.9f, y + 0.11f, -0.28f});
    }
    return builder;
}

MeshBuilder bench_frame() {
    MeshBuilder builder;
    for (const float x : {-0.7f, 0.7f}) {
        builder.box({x - 0.04f, 0.0f, -0.24f}, {x + 0.04f, 0.44f, -0.18f}, all_but_bottom);
        builder.box({x - 0.04f, 0.0f, 0.2f}, {x + 0.04f, 0.44f, 0.26f}, all_but_bottom);
        builder.box({x - 0.04f, 0.44f, -0.36f}, {x + 0.04f, 1.0f, -0.32f});
    }
    return builder;
}

void add_benches(SceneDesc& scene, const SquareMaterials& materials) {
    const std::size_t planks = add_mesh(scene, bench_planks().mesh("bench planks", materials.wood));
    const std::size_t legs = add_mesh(scene, bench_frame().mesh("bench frame", materials.metal));
    for (int i = 0; i < 12; ++i) {
        const glm::mat4 here = on_circle(13.2f, glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / 12.0f);
        place(scene, fmt::format("bench {} planks", i), planks, here);
        place(scene, fmt::format("bench {} frame", i), legs, here);
    }
}

// Stone boxes with a tree each, and hedges between the lamps of the outer circle.
void add_greenery(SceneDesc& scene, const SquareMaterials& materials) {
    std::vector<TreeMeshes> kinds;
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        kinds.push_back(add_tree_meshes(scene, materials.tree, 500 + seed));
    }
    MeshBuilder box;
    box.texture_size = 2.0f;
    box.tint = linear(0xd2c4a8);
    box.box({-1.0f, 0.0f, -1.0f}, {1.0f, 0.5f, 1.0f}, all_but_bottom);
    const std::size_t box_mesh = add_mesh(scene, box.mesh("tree box", materials.stone));
    MeshBuilder hedge;
    hedge.texture_size = 1.5f;
    hedge.shade = [](const glm::vec3& position, const glm::vec3&) {
        return 0.5f + 0.5f * glm::smoothstep(0.0f, 1.0f, position.y);
    };
    hedge.box({-2.6f, 0.0f, -0.45f}, {2.6f, 0.6f, 0.45f}, face_left | face_right | face_front | face_back);
    hedge.box({-2.6f, 0.6f, -0.45f}, {2.6f, 1.0f, 0.45f}, all_but_bottom);
    const std::size_t hedge_mesh = add_mesh(scene, hedge.mesh("hedge", materials.hedge));
    constexpr int count = 12;
    for (int i = 0; i < count; ++i) {
        const float angle = glm::two_pi<float>() * static_cast<float>(i) / count;
        if (i % 3 != 0) {
            const glm::mat4 here = on_circle(18.5f, angle);
            place(scene, fmt::format("tree box {}", i), box_mesh, here);
            place_tree(scene, fmt::format("tree {}", i), kinds[static_cast<std::size_t>(i) % kinds.size()],
                       glm::vec3(here[3]) + glm::vec3(0.0f, 0.45f, 0.0f), 0.8f + 0.25f * random_at(i, 0, 301), angle);
        }
        const float between = angle + glm::pi<float>() / count;
        place(scene, fmt::format("hedge {}", i), hedge_mesh, on_circle(23.2f, between));
    }
    for (int i = 0; i < 18; ++i) {
        const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.35f * random_at(i, 1, 301)) / 18.0f;
        const glm::vec3 foot(on_circle(40.0f + 12.0f * random_at(i, 2, 301), angle)[3]);
        place_tree(scene, fmt::format("outer tree {}", i), kinds[static_cast<std::size_t>(i) % kinds.size()], foot,
                   1.0f + 0.3f * random_at(i, 3, 301), angle);
    }
}

void add_lamps(SceneDesc& scene, const SquareMaterials& materials) {
    const LampPostMeshes post = add_lamp_post_meshes(scene, materials.metal, materials.lantern);
    for (int i = 0; i < 8; ++i) {
        const float angle = glm::two_pi<float>() * (static_cast<float>(i) + 0.5f) / 8.0f;
        place_lamp_post(scene, fmt::format("lamp {}", i), post, glm::vec3(on_circle(16.4f, angle)[3]),
                        {6.0f, 4.2f, 2.3f});
    }
}

} // namespace

SceneDesc square() {
    SceneDesc scene;
    const SquareMaterials materials = add_materials(scene);
    add_paving(scene, materials);
    add_parapet(scene, materials);
    add_fountain(scene, materials);
    add_benches(scene, materials);
    add_greenery(scene, materials);
    add_lamps(scene, materials);
    return scene;
}

} // namespace content::generator

#include "content/generator/outdoor_parts.h"

#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/surface_paint.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace content::generator {
namespace {

// A ball with bumps, flatter below.
float bumpy_radius(const glm::vec3& direction, float radius, float phase) {
    const glm::vec3 a = direction * 4.3f + phase;
    const glm::vec3 b = direction * 9.1f - 2.0f * phase;
    const float bumps = std::sin(a.x) * std::sin(a.y + 1.3f) * std::sin(a.z + 2.1f);
    const float small_bumps = std::sin(b.x + 0.7f) * std::sin(b.y) * std::sin(b.z + 1.9f);
    const float below = 1.0f - 0.22f * glm::smoothstep(0.1f, 1.0f, -direction.y);
    return radius * below * (1.0f + 0.22f * bumps + 0.10f * small_bumps);
}

constexpr float lantern_bottom = 3.85f;
constexpr double lantern_kelvin = 2700.0; // incandescent

} // namespace

TreeMaterials add_tree_materials(SceneDesc& scene) {
    const TreeMaterials materials{.bark = add_painted_material(scene, bark_image()),
                                  .leaves = add_masked_material(scene, leaf_image()),
                                  .boughs = add_plain_material(scene, "boughs")};
    scene.materials[materials.leaves].vegetation = true;
    scene.materials[materials.boughs].vegetation = true; // what shows between the leaves is leaves, too
    return materials;
}

TreeMeshes add_tree_meshes(SceneDesc& scene, const TreeMaterials& materials, std::uint32_t seed) {
    MeshBuilder trunk;
    trunk.texture_size = 1.2f;
    trunk.shade = [](const glm::vec3& position, const glm::vec3&) {
        return 0.55f + 0.45f * glm::smoothstep(0.0f, 1.0f, position.y) * glm::smoothstep(4.0f, 2.2f, position.y);
    };
    trunk.turn(std::array<ProfilePoint, 4>{{{0.26f, 0.0f}, {0.16f, 0.4f}, {0.12f, 2.4f}, {0.08f, 4.0f}}}, 7);

    MeshBuilder crown;
    crown.texture_size = 1.7f;
    crown.shade = [](const glm::vec3& position, const glm::vec3& normal) {
        const float height = glm::smoothstep(2.2f, 6.5f, position.y);
        return (0.45f + 0.55f * height) * (0.72f + 0.28f * normal.y);
    };
    const auto choice = [seed](int i) { return random_at(i, 0, seed); };
    const float phase = 6.0f * choice(0);
    MeshBuilder boughs;
    boughs.tint = linear(0x39431f);
    boughs.shade = crown.shade;
    crown.tint = glm::mix(linear(0xfff2c4), linear(0xd8efc8), choice(1));
    // What shows between the leaves: boughs in the crown's own shade.
    const auto ball = [&](const glm::vec3& centre, float radius, float shift) {
        boughs.ball(centre, 0,
                    [=](const glm::vec3& direction) { return 0.8f * bumpy_radius(direction, radius, phase + shift); });
        crown.ball(centre, 1,
                   [=](const glm::vec3& direction) { return bumpy_radius(direction, radius, phase + shift); });
    };
    constexpr int lobes = 3;
    ball({0.0f, 5.3f, 0.0f}, 1.35f, 0.0f);
    for (int i = 0; i < lobes; ++i) {
        const float angle = glm::two_pi<float>() / lobes * (static_cast<float>(i) + 0.5f * choice(2 + i));
        const float reach = 0.95f + 0.3f * choice(6 + i);
        ball({reach * std::cos(angle), 3.9f + 0.9f * choice(10 + i), reach * std::sin(angle)},
             1.35f + 0.25f * choice(14 + i), static_cast<float>(i) + 1.0f);
    }
    return {add_mesh(scene, trunk.mesh("trunk", materials.bark)),
            add_mesh(scene, crown.mesh("crown", materials.leaves)),
            add_mesh(scene, boughs.mesh("boughs", materials.boughs))};
}

void place_tree(SceneDesc& scene, const std::string& name, const TreeMeshes& tree, const glm::vec3& foot, float scale,
                float turn) {
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1.0f), foot), turn, glm::vec3(0.0f, 1.0f, 0.0f));
    const glm::mat4 world_from_tree = glm::scale(turned, glm::vec3(scale));
    place(scene, name + " trunk", tree.trunk, world_from_tree);
    place(scene, name + " boughs", tree.boughs, world_from_tree);
    place(scene, name + " crown", tree.crown, world_from_tree);
}

LampPostMeshes add_lamp_post_meshes(SceneDesc& scene, std::size_t metal, std::size_t glow) {
    scene.materials[glow].emission_temperature = static_cast<float>(lantern_kelvin);
    MeshBuilder post;
    post.turn(std::array<ProfilePoint, 9>{{{0.20f, 0.0f},
                                           {0.20f, 0.14f},
                                           {0.12f, 0.22f},
                                           {0.11f, 0.85f},
                                           {0.065f, 0.95f},
                                           {0.05f, 3.55f},
                                           {0.09f, 3.62f},
                                           {0.05f, 3.70f},
                                           {0.15f, lantern_bottom}}},
              8);
    constexpr float top = lantern_bottom + 0.55f;
    post.turn(
        std::array<ProfilePoint, 4>{{{0.30f, top}, {0.24f, top + 0.08f}, {0.05f, top + 0.30f}, {0.0f, top + 0.45f}}},
        8);
    post.turn(std::array<ProfilePoint, 2>{{{0.0f, top - 0.001f}, {0.30f, top}}}, 8);
    MeshBuilder lantern;
    lantern.turn(std::array<ProfilePoint, 2>{{{0.14f, lantern_bottom}, {0.25f, top}}}, 8);
    return {add_mesh(scene, post.mesh("lamp post", metal)), add_mesh(scene, lantern.mesh("lantern", glow))};
}

void place_lamp_post(SceneDesc& scene, const std::string& name, const LampPostMeshes& post, const glm::vec3& foot,
                     const glm::vec3& intensity) {
    const glm::mat4 world_from_post = glm::translate(glm::mat4(1.0f), foot);
    place(scene, name + " post", post.post, world_from_post);
    place(scene, name + " lantern", post.lantern, world_from_post);
    constexpr float range = 22.0f;
    scene.lamps.push_back({name + " light", foot + glm::vec3(0.0f, lantern_bottom + 0.25f, 0.0f),
                           glm::vec3(static_cast<float>(luminance_of(intensity))), range,
                           Spectrum(BlackBody{lantern_kelvin})});
}

} // namespace content::generator

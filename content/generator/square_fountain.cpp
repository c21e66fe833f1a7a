#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/square_parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace content::generator {
namespace {

constexpr int segments = 32;

void add_basin(SceneDesc& scene, const SquareMaterials& materials) {
    MeshBuilder stone;
    stone.texture_size = 2.0f;
    stone.tint = linear(0xd9cbb0);
    stone.shade = [](const glm::vec3& position, const glm::vec3& normal) {
        const float foot = 0.65f + 0.35f * glm::smoothstep(0.0f, 0.5f, position.y);
        return normal.y > 0.5f ? 1.0f : foot;
    };
    stone.turn(std::array<ProfilePoint, 9>{{{6.0f, 0.0f},
                                            {6.0f, 0.16f},
                                            {5.4f, 0.16f},
                                            {5.4f, 0.32f},
                                            {4.8f, 0.32f},
                                            {4.72f, 0.75f},
                                            {4.85f, 0.80f},
                                            {4.85f, 0.92f},
                                            {4.35f, 0.92f}}},
               segments);
    // The basin's inner wall runs down to the water.
    stone.turn(std::array<ProfilePoint, 2>{{{4.35f, 0.92f}, {4.35f, 0.6f}}}, segments);
    place(scene, "fountain basin", stone, materials.stone);
    MeshBuilder water;
    water.texture_size = 3.0f;
    water.turn(std::array<ProfilePoint, 4>{{{4.36f, 0.66f}, {2.6f, 0.66f}, {1.2f, 0.66f}, {0.0f, 0.66f}}}, segments);
    place(scene, "fountain water", water, materials.water);
}

void add_column(SceneDesc& scene, const SquareMaterials& materials) {
    MeshBuilder stone;
    stone.texture_size = 2.0f;
    stone.tint = linear(0xe2d6bd);
    stone.shade = [](const glm::vec3& position, const glm::vec3& normal) {
        return (0.7f + 0.3f * glm::smoothstep(0.6f, 1.6f, position.y)) * (normal.y < -0.3f ? 0.7f : 1.0f);
    };
    stone.turn(std::array<ProfilePoint, 10>{{{0.95f, 0.6f},
                                             {0.95f, 1.05f},
                                             {0.55f, 1.2f},
                                             {0.42f, 1.9f},
                                             {0.5f, 2.3f},
                                             {1.3f, 2.52f},
                                             {1.95f, 2.85f},
                                             {2.0f, 3.0f},
                                             {1.85f, 3.0f},
                                             {1.5f, 2.84f}}},
               24);
    stone.turn(std::array<ProfilePoint, 9>{{{0.34f, 2.8f},
                                            {0.27f, 3.5f},
                                            {0.34f, 4.0f},
                                            {0.8f, 4.15f},
                                            {1.1f, 4.4f},
                                            {1.12f, 4.5f},
                                            {1.0f, 4.5f},
                                            {0.8f, 4.4f},
                                            {0.3f, 4.36f}}},
               24);
    stone.turn(
        std::array<ProfilePoint, 5>{{{0.24f, 4.3f}, {0.17f, 4.9f}, {0.26f, 5.05f}, {0.26f, 5.15f}, {0.0f, 5.15f}}}, 16);
    place(scene, "fountain column", stone, materials.stone);
    MeshBuilder water;
    water.texture_size = 3.0f;
    water.turn(std::array<ProfilePoint, 2>{{{1.6f, 2.88f}, {0.3f, 2.88f}}}, 24);
    place(scene, "fountain bowl", water, materials.water);
}

// A ring of square section about the local y axis.
void ring(MeshBuilder& builder, float radius, float half_width) {
    const float a = radius - half_width;
    const float b = radius + half_width;
    builder.turn(
        std::array<ProfilePoint, 5>{
            {{a, -half_width}, {b, -half_width}, {b, half_width}, {a, half_width}, {a, -half_width}}},
        40);
}

void add_armillary_sphere(SceneDesc& scene, const SquareMaterials& materials) {
    MeshBuilder bronze;
    bronze.tint = linear(0xd9a94e);
    const glm::mat4 centre = glm::translate(glm::mat4(1.0f), {0.0f, 6.55f, 0.0f});
    const glm::vec3 x(1.0f, 0.0f, 0.0f);
    const glm::vec3 z(0.0f, 0.0f, 1.0f);
    const std::array tilts = {glm::rotate(glm::mat4(1.0f), 0.41f, z), glm::rotate(glm::mat4(1.0f), 1.571f, x),
                              glm::rotate(glm::mat4(1.0f), 1.571f, z),
                              glm::rotate(glm::rotate(glm::mat4(1.0f), 0.8f, z), 0.5f, x)};
    for (std::size_t i = 0; i < tilts.size(); ++i) {
        bronze.transform = centre * tilts[i];
        ring(bronze, 1.34f - 0.07f * static_cast<float>(i), i == 0 ? 0.06f : 0.032f);
    }
    bronze.transform = centre;
    bronze.tint = linear(0x4f8f8a);
    bronze.ball(glm::vec3(0.0f), 3, [](const glm::vec3&) { return 0.52f; });
    place(scene, "armillary sphere", bronze, materials.bronze);
}

} // namespace

void add_fountain(SceneDesc& scene, const SquareMaterials& materials) {
    add_basin(scene, materials);
    add_column(scene, materials);
    add_armillary_sphere(scene, materials);
}

} // namespace content::generator

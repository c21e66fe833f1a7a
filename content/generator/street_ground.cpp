#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"

#include <fmt/format.h>

namespace content::generator {
namespace {

using namespace plan;

struct Strip {
    float x0, x1, z0, z1; // x0 < x1; z0 > z1
};

// A level rectangle in pieces of about 8 m.
void pave(MeshBuilder& builder, const Strip& strip, float y) {
    constexpr float piece = 8.0f;
    const int columns = std::max(1, static_cast<int>(std::lround((strip.x1 - strip.x0) / piece)));
    const int rows = std::max(1, static_cast<int>(std::lround((strip.z0 - strip.z1) / piece)));
    for (int i = 0; i < columns; ++i) {
        for (int j = 0; j < rows; ++j) {
            const float a = glm::mix(strip.x0, strip.x1, static_cast<float>(i) / static_cast<float>(columns));
            const float b = glm::mix(strip.x0, strip.x1, static_cast<float>(i + 1) / static_cast<float>(columns));
            const float c = glm::mix(strip.z0, strip.z1, static_cast<float>(j) / static_cast<float>(rows));
            const float d = glm::mix(strip.z0, strip.z1, static_cast<float>(j + 1) / static_cast<float>(rows));
            builder.quad({{{a, y, c}, {b, y, c}, {b, y, d}, {a, y, d}}});
        }
    }
}

// A stretch of the main road whose picture spans its width; 8 m of road a picture.
void add_road(SceneDesc& scene, const std::string& name, std::size_t material, float z0, float z1) {
    MeshBuilder builder;
    constexpr float piece = 8.0f;
    const int pieces = std::max(1, static_cast<int>(std::lround((z0 - z1) / piece)));
    for (int i = 0; i < pieces; ++i) {
        const float c = glm::mix(z0, z1, static_cast<float>(i) / static_cast<float>(pieces));
        const float d = glm::mix(z0, z1, static_cast<float>(i + 1) / static_cast<float>(pieces));
        constexpr float w = road_half_width;
        builder.quad({{{-w, 0.0f, c}, {w, 0.0f, c}, {w, 0.0f, d}, {-w, 0.0f, d}}}, TextureArea{});
    }
    place(scene, name, builder, material);
}

// Darker along the house fronts at |x| = front.
float pavement_shade(const glm::vec3& position, const glm::vec3&) {
    const bool beside_cross_road = std::abs(position.z - crossing) < crossing_front;
    const float distance = beside_cross_road ? 2.0f : std::max(0.0f, front - std::abs(position.x));
    return 0.6f + 0.4f * glm::smoothstep(0.0f, 1.2f, distance);
}

void add_main_pavement(SceneDesc& scene, const StreetMaterials& materials, const std::string& name, float side,
                       float z0, float z1) {
    MeshBuilder slabs;
    slabs.texture_size = 3.0f;
    slabs.shade = pavement_shade;
    MeshBuilder kerb;
    kerb.texture_size = 2.0f;
    kerb.tint = linear(0xa79f92);
    constexpr float kerb_width = 0.3f;
    for (const glm::vec2& part :
         {glm::vec2(road_half_width + kerb_width, front - 1.2f), glm::vec2(front - 1.2f, front)}) {
        const float a = side * part.x;
        const float b = side * part.y;
        pave(slabs, {std::min(a, b), std::max(a, b), z0, z1}, kerb_height);
    }
    const float a = side * road_half_width;
    const float b = side * (road_half_width + kerb_width);
    kerb.box({std::min(a, b), 0.0f, z1}, {std::max(a, b), kerb_height, z0},
             unsigned{face_top} | face_front | face_back | (side > 0.0f ? face_left : face_right));
    place(scene, name + " slabs", slabs, materials.paving);
    place(scene, name + " kerb", kerb, materials.stone);
}

void add_cross_road(SceneDesc& scene, const StreetMaterials& materials, float side) {
    const std::string name = side < 0.0f ? "cross road west" : "cross road east";
    const float a = side * road_half_width;
    const float b = side * crossing_length;
    const float low = std::min(a, b);
    const float high = std::max(a, b);
    MeshBuilder road;
    road.texture_size = 8.0f;
    pave(road, {low, high, crossing + crossing_half_width, crossing - crossing_half_width}, 0.0f);
    place(scene, name, road, materials.asphalt);
    MeshBuilder slabs;
    slabs.texture_size = 3.0f;
    MeshBuilder kerb;
    kerb.tint = linear(0xa79f92);
    kerb.texture_size = 2.0f;
    for (const float along : {-1.0f, 1.0f}) {
        const float inner = crossing + along * (crossing_half_width + 0.3f);
        const float outer = crossing + along * crossing_front;
        const float edge = crossing + along * crossing_half_width;
        const float start = side * (road_half_width + 0.3f);
        pave(slabs, {std::min(start, b), std::max(start, b), std::max(inner, outer), std::min(inner, outer)},
             kerb_height);
        kerb.box({low, 0.0f, std::min(inner, edge)}, {high, kerb_height, std::max(inner, edge)},
                 unsigned{face_top} | (along > 0.0f ? face_back : face_front) | face_left | face_right);
    }
    // The main road's kerb goes on beside the corners.
    for (const float along : {-1.0f, 1.0f}) {
        const float z0 = crossing + along * (crossing_half_width + 0.3f);
        const float z1 = crossing + along * crossing_front;
        const float x0 = side * road_half_width;
        const float x1 = side * (road_half_width + 0.3f);
        kerb.box({std::min(x0, x1), 0.0f, std::min(z0, z1)}, {std::max(x0, x1), kerb_height, std::max(z0, z1)},
                 unsigned{face_top} | (side > 0.0f ? face_left : face_right));
    }
    place(scene, name + " pavements", slabs, materials.paving);
    place(scene, name + " kerbs", kerb, materials.stone);
}

void add_land(SceneDesc& scene, const StreetMaterials& materials) {
    constexpr float size = 320.0f;
    constexpr float tile = 64.0f;
    constexpr float depth = -0.25f; // well below the road, so that the two never fight for a pixel
    constexpr float middle = -80.0f;
    const int count = static_cast<int>(2.0f * size / tile);
    MeshBuilder land;
    land.texture_size = 16.0f;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < count; ++j) {
            const float x = -size + tile * static_cast<float>(i);
            const float z = middle + size - tile * static_cast<float>(j);
            land.quad({{{x, depth, z}, {x + tile, depth, z}, {x + tile, depth, z - tile}, {x, depth, z - tile}}});
        }
    }
    place(scene, "land", land, materials.grass);
}

} // namespace

void add_street_ground(SceneDesc& scene, const StreetMaterials& materials) {
    constexpr float zebra = 4.0f;
    constexpr float near_zebra = crossing + crossing_front + 1.0f;
    constexpr float far_zebra = crossing - crossing_front - 1.0f;
    add_road(scene, "road near", materials.road, near_end, near_zebra + zebra);
    add_road(scene, "zebra crossing near", materials.zebra, near_zebra + zebra, near_zebra);
    add_road(scene, "road before the crossing", materials.asphalt, near_zebra, crossing + crossing_half_width);
    add_road(scene, "crossing", materials.asphalt, crossing + crossing_half_width, crossing - crossing_half_width);
    add_road(scene, "road after the crossing", materials.asphalt, crossing - crossing_half_width, far_zebra);
    add_road(scene, "zebra crossing far", materials.zebra, far_zebra, far_zebra - zebra);
    add_road(scene, "road far", materials.road, far_zebra - zebra, far_end);
    for (const float side : {-1.0f, 1.0f}) {
        const std::string name = side < 0.0f ? "pavement west" : "pavement east";
        add_main_pavement(scene, materials, name + " near", side, near_end, crossing + crossing_front);
        add_main_pavement(scene, materials, name + " far", side, crossing - crossing_front, far_end);
        add_cross_road(scene, materials, side);
    }
    MeshBuilder squares;
    squares.texture_size = 3.0f;
    pave(squares, {-45.0f, 45.0f, near_row, near_end}, 0.0f);
    pave(squares, {-32.0f, 32.0f, far_end, square_end}, 0.0f);
    place(scene, "squares", squares, materials.paving);
    add_land(scene, materials);
}

} // namespace content::generator

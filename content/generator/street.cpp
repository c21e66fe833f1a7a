#include "content/generator/models.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

namespace content::generator {
namespace {

using namespace plan;

constexpr std::array<std::uint32_t, 9> plaster_colours = {0xf1e3c2, 0xe3b86f, 0xd58f68, 0xe3b7a4, 0xb9c4a3,
                                                          0xaec3d0, 0xf3ecdc, 0xe9cf9b, 0xcf9f86};
constexpr std::array<std::uint32_t, 3> brick_colours = {0xc47a58, 0xb5664c, 0xcf9a72};
constexpr std::array<std::uint32_t, 3> trim_colours = {0xf4eee0, 0xe2cfa8, 0xdcd6ca};
constexpr std::array<std::uint32_t, 4> roof_colours = {0xc46a45, 0xb0573a, 0x9a5a44, 0x7b818a};
constexpr std::array<std::uint32_t, 4> shutter_colours = {0x4f6f5c, 0x5b7488, 0x8a4a3a, 0x6c7350};

template <std::size_t count>
glm::vec3 pick(const std::array<std::uint32_t, count>& colours, int index, std::uint32_t seed) {
    const auto choice = static_cast<std::size_t>(random_at(index, 0, seed) * static_cast<float>(count));
    return linear(colours[choice]);
}

// The house's looks from its number alone.
House house_of(const std::string& row, int index, std::uint32_t seed) {
    House house;
    house.name = fmt::format("house {} {}", row, index);
    house.seed = seed * 64U + static_cast<std::uint32_t>(index);
    house.floors = 2 + static_cast<int>(2.4f * random_at(index, 1, seed));
    house.roof = random_at(index, 2, seed) < 0.36f ? RoofKind::gable : RoofKind::eaves;
    house.brick = random_at(index, 3, seed) < 0.26f;
    house.shop = random_at(index, 4, seed) < 0.30f;
    house.shutters = !house.brick && random_at(index, 5, seed) < 0.45f;
    // Neighbours differ: the palette is walked through, not drawn from.
    house.wall_tint =
        house.brick ? pick(brick_colours, index, seed + 1)
                    : linear(plaster_colours[(static_cast<std::size_t>(index) * 4 + seed) % plaster_colours.size()]);
    house.trim_tint = pick(trim_colours, index, seed + 2);
    house.roof_tint = pick(roof_colours, index, seed + 3);
    house.shutter_tint = pick(shutter_colours, index, seed + 4);
    return house;
}

void set_width(House& house, float width) {
    house.width = width;
    house.bays = std::max(2, static_cast<int>(std::lround(width / (house.shutters ? 3.0f : 2.6f))));
}

struct Row {
    std::string name;
    glm::vec3 start; ///< where the first house's front begins, at its lower left as seen from the street
    float heading;   ///< radians about +y from local x (along the fronts) = world +x
    float length;
    std::uint32_t seed;
    bool corner_at_start = false;
    bool corner_at_end = false;
};

// Houses side by side, their fronts in one line, filling the row's length.
void add_row(SceneDesc& scene, const StreetMaterials& materials, const Row& row) {
    std::vector<float> widths;
    float total = 0.0f;
    for (int i = 0; total < row.length - 4.0f; ++i) {
        widths.push_back(6.6f + 4.2f * random_at(i, 9, row.seed));
        total += widths.back();
    }
    float x = 0.0f;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        House house = house_of(row.name, static_cast<int>(i), row.seed);
        const float width = widths[i] * row.length / total;
        set_width(house, width);
        house.windows_left = row.corner_at_start && i == 0;
        house.windows_right = row.corner_at_end && i + 1 == widths.size();
        if (house.windows_left || house.windows_right) {
            house.floors = 3;
            house.roof = RoofKind::eaves;
        }
        const glm::mat4 heading =
            glm::rotate(glm::translate(glm::mat4(1.0f), row.start), row.heading, glm::vec3(0.0f, 1.0f, 0.0f));
        house.world_from_house = glm::translate(heading, glm::vec3(x, 0.0f, 0.0f));
        add_house(scene, materials, house);
        x += width;
    }
}

void add_houses(SceneDesc& scene, const StreetMaterials& materials) {
    constexpr auto half_pi = glm::half_pi<float>();
    constexpr float near_length = near_end - (crossing + crossing_front);
    constexpr float far_length = crossing - crossing_front - far_end;
    const float depth = House{}.depth;
    add_row(scene, materials, {"west near", {-front, 0.0f, near_end}, half_pi, near_length, 3, true, true});
    add_row(scene, materials,
            {"west far", {-front, 0.0f, crossing - crossing_front}, half_pi, far_length, 4, true, true});
    add_row(scene, materials,
            {"east near", {front, 0.0f, crossing + crossing_front}, -half_pi, near_length, 5, true, true});
    add_row(scene, materials, {"east far", {front, 0.0f, far_end}, -half_pi, far_length, 6, true, true});
    add_row(scene, materials, {"behind", {33.0f, 0.0f, near_row}, glm::pi<float>(), 66.0f, 7, true, true});
    constexpr float side_length = 36.0f;
    const float side_start = front + depth;
    constexpr float near_front = crossing + crossing_front;
    constexpr float far_front = crossing - crossing_front;
    add_row(scene, materials,
            {"side north west", {-side_start - side_length, 0.0f, far_front}, 0.0f, side_length, 8, true, false});
    add_row(scene, materials, {"side north east", {side_start, 0.0f, far_front}, 0.0f, side_length, 9, false, true});
    add_row(scene, materials,
            {"side south west", {-side_start, 0.0f, near_front}, glm::pi<float>(), side_length, 10, false, true});
    add_row(scene, materials,
            {"side south east",
             {side_start + side_length, 0.0f, near_front},
             glm::pi<float>(),
             side_length,
             11,
             true,
             false});
}

void add_trees(SceneDesc& scene, const StreetMaterials& materials) {
    std::vector<TreeMeshes> kinds;
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
        kinds.push_back(add_tree_meshes(scene, materials.tree, 400 + seed));
    }
    int number = 0;
    const auto plant = [&](float x, float z, float y) {
        const TreeMeshes& kind = kinds[static_cast<std::size_t>(number) % kinds.size()];
        place_tree(scene, fmt::format("tree {}", number), kind, {x, y, z}, 0.85f + 0.35f * random_at(number, 0, 77),
                   6.2831853f * random_at(number, 1, 77));
        ++number;
    };
    for (int i = 0; i < 6; ++i) {
        const float z = 22.0f - 15.0f * static_cast<float>(i);
        plant(i % 2 == 0 ? -5.35f : 5.35f, z, kerb_height);
    }
    for (int i = 0; i < 7; ++i) {
        const float z = -91.0f - 14.5f * static_cast<float>(i);
        plant(i % 2 == 0 ? 5.35f : -5.35f, z, kerb_height);
    }
    for (const float x : {-25.0f, -18.0f, -12.5f, 12.5f, 18.0f, 25.0f}) {
        plant(x, church_front - 1.0f - 0.25f * std::abs(x), 0.0f);
        plant(1.25f * x, church_front + 14.0f, 0.0f);
    }
    for (const float x : {-62.0f, -55.0f, 55.0f, 62.0f}) {
        plant(x, crossing + crossing_front + 2.0f, 0.0f);
        plant(x, crossing - crossing_front - 2.0f, 0.0f);
    }
    for (int i = 0; i < 5; ++i) {
        const float z = crossing + 4.0f * (static_cast<float>(i) - 2.0f);
        plant(-crossing_length - 4.0f, z, -0.1f);
        plant(crossing_length + 4.0f, z, -0.1f);
    }
}

void add_lamps(SceneDesc& scene, const StreetMaterials& materials) {
    const LampPostMeshes post = add_lamp_post_meshes(scene, materials.metal, materials.lantern);
    constexpr glm::vec3 intensity{9.0f, 6.3f, 3.4f};
    int number = 0;
    const auto stand = [&](float x, float z) {
        place_lamp_post(scene, fmt::format("lamp {}", number++), post, {x, kerb_height, z}, intensity);
    };
    for (int i = 0; i < 6; ++i) {
        stand(i % 2 == 0 ? 4.8f : -4.8f, 29.0f - 16.0f * static_cast<float>(i));
    }
    for (int i = 0; i < 7; ++i) {
        stand(i % 2 == 0 ? -4.8f : 4.8f, -85.0f - 15.5f * static_cast<float>(i));
    }
    stand(-7.0f, church_front + 7.0f);
    stand(7.0f, church_front + 7.0f);
}

void add_cars(SceneDesc& scene, const StreetMaterials& materials) {
    struct Parked {
        float side;
        float z;
        std::uint32_t colour;
        bool van;
    };
    constexpr std::array<Parked, 13> cars = {{{1.0f, 16.0f, 0xb8382c, false},
                                              {1.0f, 10.3f, 0x2f5a78, false},
                                              {-1.0f, 6.0f, 0xe8e2d2, true},
                                              {1.0f, -9.0f, 0x4d6b4f, false},
                                              {-1.0f, -16.5f, 0x23303c, false},
                                              {-1.0f, -22.5f, 0xd9a32e, false},
                                              {1.0f, -40.0f, 0xc9c9c4, true},
                                              {-1.0f, -50.0f, 0x7c2530, false},
                                              {1.0f, -96.0f, 0xe2dccb, false},
                                              {1.0f, -102.0f, 0x35506e, false},
                                              {-1.0f, -118.0f, 0x6d7f5a, true},
                                              {1.0f, -140.0f, 0xb24a30, false},
                                              {-1.0f, -152.0f, 0xd8d4c8, false}}};
    for (std::size_t i = 0; i < cars.size(); ++i) {
        const Parked& car = cars[i];
        add_car(scene, materials, fmt::format("car {}", i), {car.side * 2.95f, 0.0f, car.z}, {0.0f, 0.0f, -car.side},
                linear(car.colour), car.van);
    }
}

} // namespace

SceneDesc street() {
    SceneDesc scene;
    const StreetMaterials materials = add_street_materials(scene);
    add_street_ground(scene, materials);
    add_houses(scene, materials);
    add_church(scene, materials, church_front);
    add_trees(scene, materials);
    add_lamps(scene, materials);
    add_cars(scene, materials);
    return scene;
}

} // namespace content::generator

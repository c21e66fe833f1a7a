#pragma once

#include "content/generator/mesh_builder.h"
#include "content/generator/outdoor_parts.h"
#include "content/scene_desc.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

/// The parts that a street is put together from. Metres, y up.
namespace content::generator {

/// Indices of the street's materials.
struct StreetMaterials {
    std::size_t asphalt;
    std::size_t road;     ///< asphalt with its centre line, 8 m a picture
    std::size_t zebra;    ///< asphalt with white bars, 8 m wide
    std::size_t paving;   ///< 3 m a picture
    std::size_t ashlar;   ///< dressed blocks, 4 m a picture; tinted
    std::size_t stone;    ///< kerbs, sills, cornices; tinted
    std::size_t plaster;  ///< tinted
    std::size_t brick;    ///< tinted
    std::size_t roof;     ///< tiles; tinted
    std::size_t openings; ///< windows and doors: areas in opening_paint.h
    std::size_t shops;
    std::size_t church;
    TreeMaterials tree;
    std::size_t car;
    std::size_t metal;
    std::size_t lantern;
    std::size_t grass;
};

StreetMaterials add_street_materials(SceneDesc& scene);

enum class RoofKind : std::uint8_t {
    eaves, ///< ridge along the street
    gable, ///< gable over the street
};

/// A house whose front stands in its local plane z = 0 from x = 0 to `width`, its body behind (z < 0).
struct House {
    std::string name;
    glm::mat4 world_from_house{1.0f};
    float width = 8.0f;
    float depth = 9.0f;
    int floors = 3;
    int bays = 3;
    RoofKind roof = RoofKind::eaves;
    bool brick = false;
    bool shop = false;
    bool shutters = false;
    bool windows_left = false;  ///< a second front on the side x = 0
    bool windows_right = false; ///< a second front on the side x = width
    glm::vec3 wall_tint{1.0f};  ///< linear, as the others
    glm::vec3 trim_tint{1.0f};
    glm::vec3 roof_tint{1.0f};
    glm::vec3 shutter_tint{1.0f};
    std::uint32_t seed = 0;
};

void add_house(SceneDesc& scene, const StreetMaterials& materials, const House& house);

/// The church at the end, its tower's front in the plane z = `front`, about x = 0.
void add_church(SceneDesc& scene, const StreetMaterials& materials, float front);

/// A parked car, its nose along `heading` (horizontal, unit).
void add_car(SceneDesc& scene, const StreetMaterials& materials, const std::string& name, const glm::vec3& foot,
             const glm::vec3& heading, const glm::vec3& paint_tint, bool van);

/// Roads, pavements, kerbs and the land around.
void add_street_ground(SceneDesc& scene, const StreetMaterials& materials);

/// The plan of the street's ground, in world metres.
namespace plan {
inline constexpr float road_half_width = 4.0f;
inline constexpr float front = 7.5f; ///< |x| of the house fronts
inline constexpr float kerb_height = 0.12f;
inline constexpr float near_end = 40.0f;  ///< z where the house rows begin
inline constexpr float near_row = 55.0f;  ///< z of the fronts that close the street behind the start
inline constexpr float crossing = -70.0f; ///< z of the crossing's middle
inline constexpr float crossing_half_width = 3.5f;
inline constexpr float crossing_front = 7.0f; ///< distance of the house fronts from the crossing's middle
inline constexpr float crossing_length = 70.0f;
inline constexpr float far_end = -188.0f; ///< z where the house rows end
inline constexpr float square_end = -245.0f;
inline constexpr float church_front = -214.0f;
} // namespace plan

} // namespace content::generator

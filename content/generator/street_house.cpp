#include "content/generator/facade.h"
#include "content/generator/opening_paint.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

namespace content::generator {
namespace {

constexpr float ground_floor = 3.7f;
constexpr float upper_floor = 3.1f;
constexpr float reveal = 0.2f; // depth of a window behind the wall's face
constexpr float surround = 0.14f;

float eaves_height(const House& house) {
    return ground_floor + upper_floor * static_cast<float>(house.floors - 1) + 0.35f;
}

struct Opening {
    Rectangle area;
    TextureArea picture;
    bool is_window = true;
    bool shop = false;
};

/// The house's builders, one a material.
struct Builders {
    MeshBuilder wall;
    MeshBuilder trim;
    MeshBuilder openings;
    MeshBuilder shops;
    MeshBuilder roof;

    void set_transform(const glm::mat4& transform) {
        for (MeshBuilder* builder : {&wall, &trim, &openings, &shops, &roof}) {
            builder->transform = transform;
        }
    }
};

void add_shutters(Builders& builders, const House& house, const Rectangle& area) {
    const float width = 0.5f * (area.high.x - area.low.x);
    builders.trim.tint = house.shutter_tint;
    for (const float x : {area.low.x - surround - width, area.high.x + surround}) {
        builders.trim.box({x, area.low.y - 0.02f, 0.0f}, {x + width, area.high.y + 0.02f, 0.06f},
                          face_front | face_left | face_right);
    }
    builders.trim.tint = house.trim_tint;
}

// One cell of the front: wall around a framed opening.
void add_opening(Builders& builders, const House& house, const Rectangle& cell, const Opening& opening) {
    const Rectangle& hole = opening.area;
    const glm::vec2 below(surround, opening.is_window ? surround : 0.0f);
    const Rectangle framed{hole.low - below, hole.high + surround};
    frame(builders.wall, cell, framed, 0.0f);
    frame(builders.trim, framed, hole, 0.0f);
    reveals(builders.trim, hole, reveal);
    MeshBuilder& pane = opening.shop ? builders.shops : builders.openings;
    picture(pane, hole, -reveal, opening.picture);
    if (opening.is_window && !opening.shop) {
        builders.trim.box({framed.low.x - 0.06f, framed.low.y - 0.02f, 0.0f},
                          {framed.high.x + 0.06f, hole.low.y, 0.16f}, all_faces & ~face_back);
        builders.trim.box({framed.low.x - 0.03f, framed.high.y, 0.0f},
                          {framed.high.x + 0.03f, framed.high.y + 0.10f, 0.12f}, all_faces & ~face_back & ~face_top);
        if (house.shutters) {
            add_shutters(builders, house, hole);
        }
    }
}

// What stands in one cell; `door_bay`: the bay with the door.
Opening opening_in(const House& house, const Rectangle& cell, int floor, int bay, int door_bay) {
    const float middle = 0.5f * (cell.low.x + cell.high.x);
    const auto seed = static_cast<int>(house.seed);
    if (floor == 0 && bay == door_bay) {
        return {{{middle - 0.6f, cell.low.y}, {middle + 0.6f, cell.low.y + 2.75f}}, door_area(seed % 2), false, false};
    }
    const float half = std::min(0.58f, 0.5f * (cell.high.x - cell.low.x) - 0.35f);
    const float sill = cell.low.y + (floor == 0 ? 1.15f : 0.85f);
    const float height = floor == 0 ? 1.75f : (floor + 1 == house.floors ? 1.45f : 1.7f);
    const int variant = static_cast<int>(4.0f * random_at(bay, floor, house.seed));
    return {{{middle - half, sill}, {middle + half, sill + height}}, window_area(variant), true, false};
}

// A front of `width` with its floors; the transform is the builders'.
void add_front(Builders& builders, const House& house, float width, int bays, bool with_door) {
    const float eaves = eaves_height(house);
    const int door_bay = with_door ? static_cast<int>(house.seed) % bays : -1;
    const bool shop = house.shop && with_door;
    for (int floor = 0; floor < house.floors; ++floor) {
        const float bottom = floor == 0 ? 0.0f : ground_floor + upper_floor * static_cast<float>(floor - 1);
        const float top = floor + 1 == house.floors ? eaves : ground_floor + upper_floor * static_cast<float>(floor);
        if (floor == 0 && shop) {
            const Rectangle hole{{0.45f, 0.0f}, {width - 0.45f, 3.15f}};
            add_opening(builders, house, {{0.0f, 0.0f}, {width, top}},
                        {hole, shop_area(static_cast<int>(house.seed / 2U % 2U)), false, true});
            continue;
        }
        for (int bay = 0; bay < bays; ++bay) {
            const float step = width / static_cast<float>(bays);
            const Rectangle cell{{step * static_cast<float>(bay), bottom}, {step * static_cast<float>(bay + 1), top}};
            add_opening(builders, house, cell, opening_in(house, cell, floor, bay, door_bay));
        }
    }
    builders.trim.box({0.0f, ground_floor - 0.12f, 0.0f}, {width, ground_floor + 0.1f, 0.1f},
                      face_front | face_top | face_bottom);
    builders.trim.box({0.0f, eaves - 0.3f, 0.0f}, {width, eaves - 0.12f, 0.16f}, all_faces & ~face_back);
    builders.trim.box({0.0f, eaves - 0.12f, 0.0f}, {width, eaves, 0.32f}, all_faces & ~face_back);
}

void add_gable(MeshBuilder& builder, float left, float right, float base, float peak, float z) {
    builder.triangle({{{left, base, z}, {right, base, z}, {0.5f * (left + right), peak, z}}});
}

struct RoofSize {
    float width;
    float depth;
    float eaves;
    float peak;
    float over;       // beyond the walls at the eaves
    float verge_over; // beyond the walls at the ends
};

// A pitched roof over x in [0, width], z in [-depth, 0]; its ridge runs along x.
void add_pitched_roof(Builders& builders, const RoofSize& size) {
    const auto [width, depth, eaves, peak, over, verge_over] = size;
    const float middle = -0.5f * depth;
    const float slope = (peak - eaves) / (0.5f * depth);
    const float low = eaves - over * slope;
    const float a = -verge_over;
    const float b = width + verge_over;
    MeshBuilder& roof = builders.roof;
    const float length = std::hypot(0.5f * depth + over, peak - low) / roof.texture_size;
    const TextureArea area{{0.0f, 0.0f}, {(b - a) / roof.texture_size, length}};
    roof.quad({{{a, low, over}, {b, low, over}, {b, peak, middle}, {a, peak, middle}}}, area);
    roof.quad({{{b, low, -depth - over}, {a, low, -depth - over}, {a, peak, middle}, {b, peak, middle}}}, area);
    // The underside that shows in front, and the verges.
    roof.quad({{{a, low - 0.12f, over}, {b, low - 0.12f, over}, {b, low, over}, {a, low, over}}});
    builders.trim.quad(
        {{{a, low - 0.12f, over}, {a, eaves - 0.12f, 0.0f}, {b, eaves - 0.12f, 0.0f}, {b, low - 0.12f, over}}});
    for (const float x : {a, b}) {
        const std::array<glm::vec3, 4> front = {
            {{x, low - 0.12f, over}, {x, low, over}, {x, peak, middle}, {x, peak - 0.15f, middle}}};
        const std::array<glm::vec3, 4> back = {
            {{x, low - 0.12f, -depth - over}, {x, low, -depth - over}, {x, peak, middle}, {x, peak - 0.15f, middle}}};
        const auto verge = [&builders](const std::array<glm::vec3, 4>& q, bool reversed) {
            builders.trim.quad(reversed ? std::array<glm::vec3, 4>{q[3], q[2], q[1], q[0]} : q);
        };
        verge(front, x > a);
        verge(back, x == a);
    }
}

void add_chimney(Builders& builders, const glm::vec2& foot, float bottom, float top) {
    builders.wall.box({foot.x - 0.35f, bottom, foot.y - 0.45f}, {foot.x + 0.35f, top, foot.y + 0.45f},
                      face_left | face_right | face_front | face_back);
    builders.trim.box({foot.x - 0.42f, top, foot.y - 0.52f}, {foot.x + 0.42f, top + 0.15f, foot.y + 0.52f});
    const std::array<ProfilePoint, 3> pot = {{{0.15f, 0.0f}, {0.12f, 0.5f}, {0.0f, 0.5f}}};
    const glm::mat4 keep = builders.roof.transform;
    for (const float z : {-0.22f, 0.22f}) {
        builders.roof.transform = keep * glm::translate(glm::mat4(1.0f), {foot.x, top + 0.15f, foot.y + z});
        builders.roof.turn(pot, 6);
    }
    builders.roof.transform = keep;
}

// A dormer that looks out of the front slope.
void add_dormer(Builders& builders, float x, float y, float depth_at_bottom, float slope, int variant) {
    constexpr float half = 0.75f;
    constexpr float height = 1.35f;
    const float z = depth_at_bottom;
    const float top = y + height;
    const float roof_end = z - (height + 0.5f) / slope;
    const Rectangle front{{x - half, y}, {x + half, top}};
    const Rectangle window{front.low + glm::vec2(0.16f, 0.12f), front.high - glm::vec2(0.16f, 0.12f)};
    frame(builders.trim, front, window, z);
    picture(builders.openings, window, z, window_area(variant));
    const float side_end = z - height / slope;
    builders.wall.triangle({{{x - half, y, z}, {x - half, top, z}, {x - half, top, side_end}}});
    builders.wall.triangle({{{x + half, y, z}, {x + half, top, side_end}, {x + half, top, z}}});
    add_gable(builders.wall, x - half, x + half, top, top + 0.5f, z);
    const float over = 0.15f;
    const float drop = over * 0.5f / half;
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 ridge_front{x, top + 0.5f, z + over};
        const glm::vec3 ridge_back{x, top + 0.5f, roof_end};
        const glm::vec3 eave_front{x + side * (half + over), top - drop, z + over};
        const glm::vec3 eave_back{x + side * (half + over), top - drop, side_end};
        if (side > 0.0f) {
            builders.roof.quad({ridge_front, eave_front, eave_back, ridge_back});
        } else {
            builders.roof.quad({ridge_back, eave_back, eave_front, ridge_front});
        }
    }
}

// Party and back walls, and what closes the roof's ends.
void add_plain_walls(Builders& builders, const House& house) {
    const float top = eaves_height(house);
    unsigned faces = face_back;
    faces |= house.windows_left ? 0U : unsigned{face_left};
    faces |= house.windows_right ? 0U : unsigned{face_right};
    builders.wall.box({0.0f, 0.0f, -house.depth}, {house.width, top, 0.0f}, faces);
}

void add_roof(Builders& builders, const House& house) {
    const float eaves = eaves_height(house);
    const glm::mat4 quarter = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f));
    const bool along = house.roof == RoofKind::eaves;
    // Along the gable house's ridge the roof's local x runs backwards from the front.
    const glm::mat4 turned =
        along ? glm::mat4(1.0f) : glm::translate(glm::mat4(1.0f), {house.width, 0.0f, 0.0f}) * quarter;
    const float width = along ? house.width : house.depth;
    const float depth = along ? house.depth : house.width;
    const float peak = eaves + 0.5f * depth * (along ? 0.85f : 1.15f);
    builders.set_transform(house.world_from_house * turned);
    // Towards the neighbours a roof ends with its house: two that lie in one plane would flicker where they overlap.
    add_pitched_roof(builders, {width, depth, eaves, peak, along ? 0.45f : 0.05f, along ? 0.0f : 0.3f});
    const glm::mat4 to_left =
        turned * glm::rotate(glm::mat4(1.0f), -glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f));
    builders.set_transform(house.world_from_house * to_left);
    add_gable(builders.wall, -depth, 0.0f, eaves, peak, 0.0f);
    const glm::mat4 to_right = turned * glm::translate(glm::mat4(1.0f), {width, 0.0f, 0.0f}) * quarter;
    builders.set_transform(house.world_from_house * to_right);
    add_gable(builders.wall, 0.0f, depth, eaves, peak, 0.0f);
    builders.set_transform(house.world_from_house);
    if (along) {
        const float slope = (peak - eaves) / (0.5f * depth);
        for (int i = 0; i < house.bays - 1; ++i) {
            const float x = house.width * static_cast<float>(i + 1) / static_cast<float>(house.bays);
            add_dormer(builders, x, eaves + 0.75f, -0.75f / slope, slope,
                       static_cast<int>(house.seed + static_cast<unsigned>(i)) % 4);
        }
    } else {
        const float middle = 0.5f * house.width;
        const Rectangle window{{middle - 0.5f, eaves + 0.8f}, {middle + 0.5f, eaves + 2.2f}};
        const Rectangle framed{window.low - surround, window.high + surround};
        constexpr float out = 0.12f; // stands out of the gable, which has no hole
        builders.trim.box({framed.low, 0.0f}, {framed.high, out}, all_faces & ~face_back & ~face_front);
        frame(builders.trim, framed, window, out);
        picture(builders.openings, window, out, window_area(0));
    }
    const float chimney_x = house.seed % 2U == 0U ? 0.8f : house.width - 0.8f;
    add_chimney(builders, {chimney_x, -0.62f * house.depth}, eaves, eaves + 0.5f * depth * 0.85f + 1.2f);
}

} // namespace

void add_house(SceneDesc& scene, const StreetMaterials& materials, const House& house) {
    Builders builders;
    const float eaves = eaves_height(house);
    const auto shade = [eaves](const glm::vec3& position, const glm::vec3&) {
        const float foot = 0.55f + 0.45f * glm::smoothstep(0.0f, 2.2f, position.y);
        const float under_eaves = 0.65f + 0.35f * glm::smoothstep(0.0f, 1.0f, std::abs(eaves - 0.3f - position.y));
        return foot * under_eaves;
    };
    for (MeshBuilder* builder : {&builders.wall, &builders.trim, &builders.openings, &builders.shops}) {
        builder->shade = shade;
    }
    builders.wall.tint = house.wall_tint;
    builders.wall.texture_size = house.brick ? 2.0f : 4.0f;
    builders.trim.tint = house.trim_tint;
    builders.trim.texture_size = 2.0f;
    builders.roof.tint = house.roof_tint;
    builders.roof.texture_size = 2.4f;

    builders.set_transform(house.world_from_house);
    add_front(builders, house, house.width, house.bays, true);
    add_plain_walls(builders, house);
    const glm::mat4 quarter = glm::rotate(glm::mat4(1.0f), glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f));
    if (house.windows_right) {
        builders.set_transform(house.world_from_house * glm::translate(glm::mat4(1.0f), {house.width, 0.0f, 0.0f}) *
                               quarter);
        add_front(builders, house, house.depth, 3, false);
    }
    if (house.windows_left) {
        builders.set_transform(house.world_from_house * glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -house.depth}) *
                               glm::rotate(glm::mat4(1.0f), -glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f)));
        add_front(builders, house, house.depth, 3, false);
    }
    add_roof(builders, house);
    place(scene, house.name + " walls", builders.wall, house.brick ? materials.brick : materials.plaster);
    place(scene, house.name + " trim", builders.trim, materials.stone);
    place(scene, house.name + " windows", builders.openings, materials.openings);
    place(scene, house.name + " shop", builders.shops, materials.shops);
    place(scene, house.name + " roof", builders.roof, materials.roof);
}

} // namespace content::generator

#include "content/generator/facade.h"
#include "content/generator/opening_paint.h"
#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace content::generator {
namespace {

constexpr float tower_half = 4.2f;
constexpr float tower_height = 25.0f;
constexpr float nave_half = 8.5f;
constexpr float nave_eaves = 11.0f;
constexpr float nave_peak = 19.0f;
constexpr float nave_length = 26.0f;

struct Builders {
    MeshBuilder wall;
    MeshBuilder trim;
    MeshBuilder openings;
    MeshBuilder roof;

    void set_transform(const glm::mat4& transform) {
        for (MeshBuilder* builder : {&wall, &trim, &openings, &roof}) {
            builder->transform = transform;
        }
    }
};

// A wall panel with one picture let into it.
void panel(Builders& builders, const Rectangle& wall, const Rectangle& hole, const TextureArea& texture) {
    constexpr float depth = 0.35f;
    frame(builders.wall, wall, hole, 0.0f);
    reveals(builders.trim, hole, depth);
    picture(builders.openings, hole, -depth, texture);
}

Rectangle centred(float x, float y, float width, float height) {
    return {{x - 0.5f * width, y}, {x + 0.5f * width, y + height}};
}

// One side of the tower in its local plane z = 0, about x = 0.
void tower_side(Builders& builders, bool front) {
    constexpr float w = tower_half;
    if (front) {
        panel(builders, {{-w, 0.0f}, {w, 7.5f}}, centred(0.0f, 0.0f, 3.6f, 5.8f), portal_area());
        panel(builders, {{-w, 7.5f}, {w, 14.0f}}, centred(0.0f, 8.6f, 4.6f, 4.6f), rose_window_area());
    } else {
        panel(builders, {{-w, 0.0f}, {w, 14.0f}}, centred(0.0f, 8.0f, 1.6f, 4.2f), lancet_area());
    }
    panel(builders, {{-w, 14.0f}, {w, 18.4f}}, centred(0.0f, 14.7f, 3.0f, 3.0f), clock_area());
    panel(builders, {{-w, 18.4f}, {0.0f, tower_height}}, centred(-1.7f, 19.3f, 1.5f, 4.4f), lancet_area());
    panel(builders, {{0.0f, 18.4f}, {w, tower_height}}, centred(1.7f, 19.3f, 1.5f, 4.4f), lancet_area());
    for (const float y : {7.4f, 13.9f, 18.3f}) {
        builders.trim.box({-w - 0.2f, y, 0.0f}, {w + 0.2f, y + 0.3f, 0.25f}, all_faces & ~face_back);
    }
}

void add_tower(Builders& builders, float front) {
    constexpr float w = tower_half;
    const glm::mat4 middle = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, front - w});
    for (int side = 0; side < 4; ++side) {
        const glm::mat4 turned =
            glm::rotate(middle, glm::half_pi<float>() * static_cast<float>(side), glm::vec3(0.0f, 1.0f, 0.0f));
        builders.set_transform(glm::translate(turned, {0.0f, 0.0f, w}));
        tower_side(builders, side == 0);
    }
    builders.set_transform(middle);
    for (const float x : {-w, w}) {
        for (const float z : {-w, w}) {
            builders.wall.box({x - 0.55f, 0.0f, z - 0.55f}, {x + 0.55f, 17.5f, z + 0.55f}, all_but_bottom);
            builders.wall.box({x - 0.4f, 17.5f, z - 0.4f}, {x + 0.4f, tower_height, z + 0.4f}, all_but_bottom);
        }
    }
    builders.trim.box({-w - 0.6f, tower_height, -w - 0.6f}, {w + 0.6f, tower_height + 0.5f, w + 0.6f});
    builders.set_transform(glm::translate(middle, {0.0f, tower_height + 0.5f, 0.0f}));
    builders.roof.turn(
        std::array<ProfilePoint, 4>{{{w + 0.2f, 0.0f}, {w * 0.72f, 2.4f}, {w * 0.36f, 9.0f}, {0.0f, 17.0f}}}, 8);
    for (const float x : {-w, w}) {
        for (const float z : {-w, w}) {
            builders.set_transform(glm::translate(middle, {x, tower_height + 0.5f, z}));
            builders.wall.turn(std::array<ProfilePoint, 2>{{{0.55f, 0.0f}, {0.55f, 1.2f}}}, 8);
            builders.roof.turn(std::array<ProfilePoint, 2>{{{0.7f, 1.2f}, {0.0f, 4.2f}}}, 8);
        }
    }
    builders.set_transform(glm::translate(middle, {0.0f, tower_height + 17.3f, 0.0f}));
    builders.trim.tint = linear(0xe6c66a);
    builders.trim.box({-0.09f, 0.0f, -0.09f}, {0.09f, 2.2f, 0.09f});
    builders.trim.box({-0.6f, 1.3f, -0.08f}, {0.6f, 1.48f, 0.08f});
    builders.trim.tint = linear(0xe6dcc4);
}

// A side of the nave: windows between buttresses. `length` along local x.
void nave_side(Builders& builders) {
    constexpr int bays = 5;
    constexpr float step = nave_length / static_cast<float>(bays);
    for (int i = 0; i < bays; ++i) {
        const float x = step * static_cast<float>(i);
        panel(builders, {{x, 0.0f}, {x + step, nave_eaves}}, centred(x + 0.5f * step, 3.0f, 1.9f, 6.0f), lancet_area());
        builders.wall.box({x - 0.4f, 0.0f, 0.0f}, {x + 0.4f, 8.6f, 0.9f}, all_faces & ~face_back & ~face_bottom);
    }
    builders.trim.box({-0.3f, nave_eaves - 0.4f, 0.0f}, {nave_length + 0.3f, nave_eaves, 0.4f}, all_faces & ~face_back);
}

void add_nave(Builders& builders, float front) {
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    const float start = front - tower_half;
    const glm::mat4 here = glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, start});
    builders.set_transform(glm::rotate(glm::translate(here, {nave_half, 0.0f, 0.0f}), glm::half_pi<float>(), up));
    nave_side(builders);
    builders.set_transform(
        glm::rotate(glm::translate(here, {-nave_half, 0.0f, -nave_length}), -glm::half_pi<float>(), up));
    nave_side(builders);
    builders.set_transform(here);
    for (const float side : {-1.0f, 1.0f}) {
        const float middle = side * 0.5f * (nave_half + tower_half);
        const float a = std::min(side * tower_half, side * nave_half);
        panel(builders, {{a, 0.0f}, {a + nave_half - tower_half, nave_eaves}}, centred(middle, 3.2f, 1.6f, 5.4f),
              lancet_area());
    }
    constexpr float n = nave_half;
    builders.wall.triangle({{{-n, nave_eaves, 0.0f}, {n, nave_eaves, 0.0f}, {0.0f, nave_peak, 0.0f}}});
    builders.set_transform(glm::translate(here, {0.0f, 0.0f, -nave_length}) *
                           glm::rotate(glm::mat4(1.0f), glm::pi<float>(), up));
    upright(builders.wall, {{-n, 0.0f}, {n, nave_eaves}}, 0.0f);
    builders.wall.triangle({{{-n, nave_eaves, 0.0f}, {n, nave_eaves, 0.0f}, {0.0f, nave_peak, 0.0f}}});
    builders.set_transform(here);
    constexpr float over = 0.6f;
    constexpr float low = nave_eaves - over * (nave_peak - nave_eaves) / nave_half;
    constexpr float back = -nave_length - 0.3f;
    const TextureArea area{{0.0f, 0.0f}, {nave_length / 2.4f, 5.0f}};
    builders.roof.quad(
        {{{n + over, low, 0.3f}, {n + over, low, back}, {0.0f, nave_peak, back}, {0.0f, nave_peak, 0.3f}}}, area);
    builders.roof.quad(
        {{{-n - over, low, back}, {-n - over, low, 0.3f}, {0.0f, nave_peak, 0.3f}, {0.0f, nave_peak, back}}}, area);
}

void add_steps(Builders& builders, float front) {
    builders.set_transform(glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, front}));
    for (int i = 0; i < 3; ++i) {
        const float reach = 2.4f - 0.6f * static_cast<float>(i);
        const float y = 0.16f * static_cast<float>(i);
        builders.trim.box({-2.8f - 0.4f * reach, y, 0.0f}, {2.8f + 0.4f * reach, y + 0.16f, reach},
                          all_but_bottom & ~face_back);
    }
}

} // namespace

void add_church(SceneDesc& scene, const StreetMaterials& materials, float front) {
    Builders builders;
    const auto shade = [](const glm::vec3& position, const glm::vec3&) {
        return 0.6f + 0.4f * glm::smoothstep(0.0f, 4.0f, position.y);
    };
    for (MeshBuilder* builder : {&builders.wall, &builders.trim, &builders.openings}) {
        builder->shade = shade;
        builder->texture_size = 4.0f;
    }
    builders.wall.tint = linear(0xdcc79c);
    builders.trim.tint = linear(0xe6dcc4);
    builders.roof.tint = linear(0x6f8a80);
    builders.roof.texture_size = 2.4f;
    add_tower(builders, front);
    add_nave(builders, front);
    add_steps(builders, front);
    place(scene, "church walls", builders.wall, materials.ashlar);
    place(scene, "church trim", builders.trim, materials.stone);
    place(scene, "church windows", builders.openings, materials.church);
    place(scene, "church roof", builders.roof, materials.roof);
}

} // namespace content::generator

#include "content/generator/paint.h"
#include "content/generator/scene_builder.h"
#include "content/generator/street_parts.h"

#include <glm/gtc/matrix_transform.hpp>

namespace content::generator {
namespace {

// A level cross-section of the body: |x| <= half_width, front and back along z (the nose looks along -z).
struct Section {
    float y;
    float half_width;
    float front;
    float back;
};

// The four sides between two sections, and the lid of the upper one.
void loft(MeshBuilder& builder, const Section& low, const Section& high, bool lid) {
    const auto at = [](const Section& s, float side, float end) {
        return glm::vec3(side * s.half_width, s.y, end < 0.0f ? s.front : s.back);
    };
    builder.quad({at(low, -1, 1), at(low, 1, 1), at(high, 1, 1), at(high, -1, 1)});
    builder.quad({at(low, 1, -1), at(low, -1, -1), at(high, -1, -1), at(high, 1, -1)});
    builder.quad({at(low, -1, -1), at(low, -1, 1), at(high, -1, 1), at(high, -1, -1)});
    builder.quad({at(low, 1, 1), at(low, 1, -1), at(high, 1, -1), at(high, 1, 1)});
    if (lid) {
        builder.quad({at(high, -1, 1), at(high, 1, 1), at(high, 1, -1), at(high, -1, -1)});
    }
}

void add_wheels(MeshBuilder& builder, float half_width) {
    const glm::mat4 car = builder.transform;
    constexpr float radius = 0.33f;
    for (const float z : {-1.32f, 1.28f}) {
        for (const float side : {-1.0f, 1.0f}) {
            const glm::mat4 hub = glm::translate(car, {side * (half_width - 0.16f), radius, z});
            // The wheel's own y axis points outwards.
            builder.transform = glm::rotate(hub, -side * glm::half_pi<float>(), glm::vec3(0.0f, 0.0f, 1.0f));
            builder.tint = linear(0x26262a);
            builder.turn(std::array<ProfilePoint, 3>{{{radius, -0.1f}, {radius, 0.16f}, {0.21f, 0.19f}}}, 10);
            builder.tint = linear(0xb9bdc2);
            builder.turn(std::array<ProfilePoint, 2>{{{0.21f, 0.19f}, {0.0f, 0.15f}}}, 10);
        }
    }
    builder.transform = car;
}

} // namespace

void add_car(SceneDesc& scene, const StreetMaterials& materials, const std::string& name, const glm::vec3& foot,
             const glm::vec3& heading, const glm::vec3& paint_tint, bool van) {
    MeshBuilder body;
    const glm::vec3 right = glm::cross(heading, glm::vec3(0.0f, 1.0f, 0.0f));
    body.transform = glm::mat4(glm::vec4(right, 0.0f), glm::vec4(0.0f, 1.0f, 0.0f, 0.0f), glm::vec4(-heading, 0.0f),
                               glm::vec4(foot, 1.0f));
    body.shade = [](const glm::vec3& position, const glm::vec3&) {
        return 0.4f + 0.6f * glm::smoothstep(0.1f, 0.75f, position.y);
    };
    constexpr std::array<Section, 4> sections = {{{0.24f, 0.78f, -1.98f, 2.0f},
                                                  {0.46f, 0.87f, -2.12f, 2.12f},
                                                  {0.74f, 0.86f, -2.08f, 2.10f},
                                                  {0.93f, 0.77f, -1.25f, 1.98f}}};
    body.tint = paint_tint;
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        loft(body, sections[i], sections[i + 1], i + 2 == sections.size());
    }
    const Section window_foot{0.93f, 0.74f, van ? -1.2f : -0.98f, van ? 1.96f : 1.82f};
    const Section window_head{van ? 1.62f : 1.34f, 0.61f, van ? -0.55f : -0.28f, van ? 1.86f : 1.22f};
    body.tint = linear(0x2b343c);
    loft(body, window_foot, window_head, false);
    const Section roof{window_head.y + 0.09f, 0.53f, window_head.front + 0.14f, window_head.back - 0.12f};
    body.tint = paint_tint;
    loft(body, window_head, roof, true);
    for (const float side : {-1.0f, 1.0f}) {
        const float x = side * 0.62f;
        body.tint = linear(0xf4efdd);
        body.box({x - 0.16f, 0.58f, -2.16f}, {x + 0.16f, 0.72f, -2.0f}, all_but_bottom & ~face_front);
        body.tint = linear(0xa8261e);
        body.box({x - 0.14f, 0.58f, 2.0f}, {x + 0.14f, 0.74f, 2.15f}, all_but_bottom & ~face_back);
    }
    add_wheels(body, 0.87f);
    place(scene, name, body, materials.car);
}

} // namespace content::generator

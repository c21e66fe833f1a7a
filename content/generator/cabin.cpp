#include "content/generator/cabin.h"

#include "content/generator/mesh_builder.h"
#include "content/generator/paint.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace content::generator {
namespace {

/// A four-cornered face in `columns` x `rows` parts, so that light and shade can change over it.
void patch(MeshBuilder& builder, const std::array<glm::vec3, 4>& corners, int columns, int rows) {
    const auto at = [&](int column, int row) {
        const float s = static_cast<float>(column) / static_cast<float>(columns);
        const float t = static_cast<float>(row) / static_cast<float>(rows);
        return glm::mix(glm::mix(corners[0], corners[1], s), glm::mix(corners[3], corners[2], s), t);
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            builder.quad({at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
        }
    }
}

/// A patch that is seen from both sides.
void sheet(MeshBuilder& builder, const std::array<glm::vec3, 4>& corners, int columns, int rows) {
    patch(builder, corners, columns, rows);
    patch(builder, {corners[1], corners[0], corners[3], corners[2]}, columns, rows);
}

/// Where a vertical profile stands: distance from the pilot's eyes on the level, and height.
struct Station {
    float distance;
    float height;
};

/// A profile swept around the pilot, from `from` to `to` radians to the right of ahead; its visible side is to the left
/// of its direction, seen with the distance to the right and the height upwards.
void sweep_around(MeshBuilder& builder, std::span<const Station> profile, float from, float to, int segments) {
    const auto at = [&](const Station& station, int i) {
        const float angle = from + (to - from) * static_cast<float>(i) / static_cast<float>(segments);
        return glm::vec3(station.distance * std::sin(angle), station.height, -station.distance * std::cos(angle));
    };
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
        for (int i = 0; i < segments; ++i) {
            builder.quad({at(profile[k], i), at(profile[k], i + 1), at(profile[k + 1], i + 1), at(profile[k + 1], i)});
        }
    }
}

PanelScreen screen(double yaw, double half_width, double from, double to) {
    constexpr double distance = 0.80;
    constexpr double pitch = -0.396; // radians
    constexpr double half_height = 0.0855;
    const glm::dvec3 look(std::cos(pitch) * std::sin(yaw), std::sin(pitch), -std::cos(pitch) * std::cos(yaw));
    const glm::dvec3 right(std::cos(yaw), 0.0, std::sin(yaw));
    return {distance * look, half_width * right, half_height * glm::cross(right, look), {from, 0.0}, {to, 1.0}};
}

void add_bezel(MeshBuilder& builder, const PanelScreen& screen) {
    const glm::vec3 centre(screen.centre);
    const glm::vec3 right(screen.right);
    const glm::vec3 up(screen.up);
    const glm::vec3 normal = glm::normalize(glm::cross(right, up));
    constexpr float rim = 0.013f;
    const glm::vec3 wide = right * (1.0f + rim / glm::length(right));
    const glm::vec3 high = up * (1.0f + rim / glm::length(up));
    const glm::vec3 raised = 0.008f * normal;
    const glm::vec3 behind = -0.03f * normal;
    const auto ring = [](const glm::vec3& middle, const glm::vec3& x, const glm::vec3& y) {
        return std::array<glm::vec3, 4>{middle - x - y, middle + x - y, middle + x + y, middle - x + y};
    };
    const auto inner = ring(centre, right, up);
    const auto edge = ring(centre + raised, 0.5f * (right + wide), 0.5f * (up + high));
    const auto outer = ring(centre, wide, high);
    const auto back = ring(centre + behind, wide, high);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        patch(builder, {outer[i], outer[j], edge[j], edge[i]}, 6, 1);
        patch(builder, {edge[i], edge[j], inner[j], inner[i]}, 6, 1);
        patch(builder, {back[i], back[j], outer[j], outer[i]}, 6, 1);
    }
}

/// Half of an upright rounded arch, from one sill over the top to the other.
std::vector<glm::vec3> arch(float half_width, float foot, float top, float z) {
    constexpr int segments = 28;
    std::vector<glm::vec3> path;
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::pi<float>() * (1.0f - static_cast<float>(i) / static_cast<float>(segments));
        const float across = std::cos(angle);
        const float rise = std::max(std::sin(angle), 0.0f);
        // A superellipse: rounder in the shoulders than an ellipse.
        path.emplace_back(std::copysign(std::pow(std::abs(across), 0.62f), across) * half_width,
                          foot + (top - foot) * std::pow(rise, 0.62f), z);
    }
    return path;
}

std::vector<glm::vec3> straight(const glm::vec3& from, const glm::vec3& to, int segments) {
    std::vector<glm::vec3> path;
    for (int i = 0; i <= segments; ++i) {
        path.push_back(glm::mix(from, to, static_cast<float>(i) / static_cast<float>(segments)));
    }
    return path;
}

constexpr float sill_height = -0.27f;
constexpr float frame_ahead = -0.86f;
constexpr float frame_behind = 0.5f;

void add_canopy_frame(MeshBuilder& builder) {
    builder.tint = linear(0x8d9298);
    builder.tube(arch(0.80f, sill_height, 0.435f, frame_ahead), 0.019f, 10);
    builder.tube(arch(0.66f, sill_height, 0.47f, frame_behind), 0.019f, 10);
    const std::array<glm::vec3, 7> spine{{{0.0f, 0.435f, -0.86f},
                                          {0.0f, 0.49f, -0.6f},
                                          {0.0f, 0.52f, -0.35f},
                                          {0.0f, 0.53f, -0.1f},
                                          {0.0f, 0.52f, 0.15f},
                                          {0.0f, 0.50f, 0.35f},
                                          {0.0f, 0.47f, 0.5f}}};
    builder.tube(spine, 0.014f, 8);
    for (const float side : {-1.0f, 1.0f}) {
        builder.tube(straight({side * 0.80f, sill_height, frame_ahead}, {side * 0.66f, sill_height, frame_behind}, 10),
                     0.026f, 10);
    }
}

/// The hull ahead of the canopy, and its stripes.
void add_nose(MeshBuilder& builder) {
    struct Section {
        float z;
        float half_width;
        float top;
        float depth;
    };
    constexpr std::array<Section, 8> sections{{{-0.92f, 0.86f, -0.30f, 0.45f},
                                               {-1.3f, 0.80f, -0.315f, 0.45f},
                                               {-1.8f, 0.68f, -0.345f, 0.42f},
                                               {-2.3f, 0.54f, -0.385f, 0.37f},
                                               {-2.8f, 0.39f, -0.435f, 0.30f},
                                               {-3.2f, 0.26f, -0.485f, 0.22f},
                                               {-3.5f, 0.14f, -0.535f, 0.13f},
                                               {-3.66f, 0.0f, -0.59f, 0.0f}}};
    constexpr int around = 20;
    const auto at = [](const Section& s, int i) {
        const float angle = glm::pi<float>() * static_cast<float>(i) / static_cast<float>(around);
        const float height = std::pow(std::max(std::sin(angle), 0.0f), 0.8f);
        return glm::vec3(-std::cos(angle) * s.half_width, s.top - s.depth * (1.0f - height), s.z);
    };
    for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
        for (int i = 0; i < around; ++i) {
            const bool stripe = i == around / 2 - 1 || i == around / 2;
            builder.tint = stripe ? linear(0x2b4a5e) : linear(0xb9b7ae);
            builder.quad(
                {at(sections[k], i), at(sections[k], i + 1), at(sections[k + 1], i + 1), at(sections[k + 1], i)});
        }
    }
}

void add_panel(MeshBuilder& builder, const std::vector<PanelScreen>& screens) {
    constexpr float reach = 1.3f; // radians to either side
    constexpr int segments = 36;
    builder.tint = linear(0x34383b);
    sweep_around(builder,
                 std::array<Station, 5>{
                     {{0.72f, -0.203f}, {0.713f, -0.192f}, {0.725f, -0.183f}, {0.98f, -0.213f}, {1.24f, -0.33f}}},
                 -reach, reach, segments);
    builder.tint = linear(0x22262a);
    sweep_around(builder, std::array<Station, 3>{{{0.80f, -0.425f}, {0.86f, -0.222f}, {0.72f, -0.203f}}}, -reach, reach,
                 segments);
    builder.tint = linear(0x3a3f43);
    sweep_around(builder,
                 std::array<Station, 4>{{{0.72f, -0.95f}, {0.615f, -0.475f}, {0.63f, -0.45f}, {0.80f, -0.425f}}},
                 -reach, reach, segments);
    builder.tint = linear(0x17191b);
    for (const PanelScreen& screen : screens) {
        add_bezel(builder, screen);
    }
}

void add_tub(MeshBuilder& builder) {
    builder.tint = linear(0x5b6160);
    constexpr float floor = -1.05f;
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 upper_ahead{side * 0.80f, sill_height, frame_ahead};
        const glm::vec3 upper_behind{side * 0.66f, sill_height, frame_behind};
        sheet(builder,
              {glm::vec3(side * 0.5f, floor, frame_ahead), glm::vec3(side * 0.5f, floor, frame_behind), upper_behind,
               upper_ahead},
              10, 5);
        builder.box(glm::min(glm::vec3(side * 0.36f, -0.60f, -0.5f), glm::vec3(side * 0.6f, -0.47f, 0.3f)),
                    glm::max(glm::vec3(side * 0.36f, -0.60f, -0.5f), glm::vec3(side * 0.6f, -0.47f, 0.3f)));
    }
    sheet(builder,
          {{{-0.5f, floor, frame_behind},
            {0.5f, floor, frame_behind},
            {0.5f, floor, frame_ahead},
            {-0.5f, floor, frame_ahead}}},
          6, 8);
    sheet(builder,
          {{{-0.5f, floor, frame_behind},
            {0.5f, floor, frame_behind},
            {0.66f, sill_height, frame_behind},
            {-0.66f, sill_height, frame_behind}}},
          6, 5);
    builder.tint = linear(0x4a3a30); // the seat
    builder.box({-0.25f, -0.78f, -0.42f}, {0.25f, -0.64f, 0.14f});
    builder.box({-0.25f, -0.78f, 0.14f}, {0.25f, -0.24f, 0.26f});
    builder.tint = linear(0x2a2c2e); // stick and throttle
    for (const float side : {-1.0f, 1.0f}) {
        const glm::vec3 foot(side * 0.48f, -0.47f, -0.36f);
        const glm::vec3 grip = foot + glm::vec3(0.0f, 0.12f, side < 0.0f ? -0.06f : 0.01f);
        builder.tube(straight(foot, grip, 4), 0.012f, 8);
        builder.ball(grip, 1, [](const glm::vec3& direction) { return 0.026f + 0.012f * direction.y * direction.y; });
    }
}

} // namespace

Cabin make_cabin() {
    // Widths of the screens' parts as in panel_aspect: 306 + 540 + 306 points of 162.
    constexpr double left_share = 306.0 / 1152.0;
    Cabin cabin;
    cabin.screens = {screen(-0.635, 0.1615, 0.0, left_share), screen(0.0, 0.285, left_share, 1.0 - left_share),
                     screen(0.635, 0.1615, 1.0 - left_share, 1.0)};
    MeshBuilder builder;
    add_nose(builder);
    add_panel(builder, cabin.screens);
    add_canopy_frame(builder);
    add_tub(builder);
    cabin.mesh = builder.mesh("cabin", 0);
    return cabin;
}

} // namespace content::generator

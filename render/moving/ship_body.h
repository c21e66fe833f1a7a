#pragma once

#include "content/scene_desc.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

/// A ship as a rigid body: triangles in vehicle axes (x right, y up, -z ahead), scene metres.
namespace render {

/// What is flame of a ship: as long as its thrust is strong.
enum class Flame : std::uint8_t { none, aft, ahead };

struct BodyVertex {
    std::uint32_t point = 0; ///< into the points, which corners share
    glm::vec3 normal{0.0f, 1.0f, 0.0f};
    glm::vec3 reflectance{0.0f};
    glm::vec3 emission{0.0f};
};

struct BodyTriangle {
    std::array<std::uint32_t, 3> vertices{}; ///< counter-clockwise seen from outside
    Flame flame = Flame::none;
};

struct ShipBody {
    std::vector<glm::dvec3> points;
    std::vector<Flame> flames; ///< by point
    std::vector<BodyVertex> vertices;
    std::vector<BodyTriangle> triangles;
    double aft_root = 0.0; ///< z where the flames begin
    double ahead_root = 0.0;
};

/// The body of a model. Materials whose names begin with "exhaust aft" or "exhaust ahead" are flames; textures are
/// left out, an unlit material's base colour is its emission.
ShipBody make_ship_body(const content::SceneDesc& model);

/// A body under thrust: its flames have the length of `thrust`, the thrust ahead over full thrust.
struct BodyShape {
    std::vector<glm::dvec3> points;                      ///< as ShipBody::points
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< into ShipBody::vertices; flames that burn not are missing
};
BodyShape shape_under_thrust(const ShipBody& body, double thrust);

} // namespace render

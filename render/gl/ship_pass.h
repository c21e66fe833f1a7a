#pragma once

#include "render/gl/gl_objects.h"
#include "render/gl/tile_planner.h"
#include "render/moving/seen_ships.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace render {

/// Draws ships as they are seen into the pictures of the world at rest, among the scenery that is there already. Costs
/// nothing until the first ship.
class ShipPass {
  public:
    /// How light is written.
    struct LightSettings {
        float gain = 1.0f;
        float coverage = 1.0f; ///< alpha
    };

    /// Draws each tile's part at its place in the bound framebuffer; returns the triangles submitted. Without
    /// `light`: (distance from the eye in metres, object index).
    std::int64_t draw(const std::vector<SeenShip>& ships, const TilePlan& plan, const glm::dmat3& axis_from_world,
                      const std::optional<LightSettings>& light);

  private:
    void create();

    Program light_;
    Program data_;
    VertexArray vertex_array_;
};

} // namespace render

#include "render/gl/ship_pass.h"

#include "render/gl/scene_bindings.h"
#include "render/gl/shader_library.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cstddef>

namespace render {
namespace {

/// Whether a sphere about `centre` reaches into a tile: before all of the planes through the eye and the tile's edges.
bool reaches(const glm::dmat3& texels_from_world, const glm::dvec2& size, const SeenShip& ship) {
    const glm::dmat3 rows = glm::transpose(texels_from_world);
    const std::array<glm::dvec3, 4> inwards{rows[0], size.x * rows[2] - rows[0], rows[1], size.y * rows[2] - rows[1]};
    for (const glm::dvec3& plane : inwards) {
        if (glm::dot(plane, glm::dvec3(ship.centre)) < -glm::length(plane) * static_cast<double>(ship.radius)) {
            return false;
        }
    }
    return true;
}

} // namespace

void ShipPass::create() {
    light_ = make_program("ship.vert", "ship.frag");
    data_ = make_program("ship.vert", "ship.frag", "#define DATA\n");
    vertex_array_ = VertexArray::create();
    float_attribute(vertex_array_.name(), 0, 3, GL_FLOAT, GL_FALSE, offsetof(SeenShip::Vertex, from_eye));
    float_attribute(vertex_array_.name(), 1, 3, GL_FLOAT, GL_FALSE, offsetof(SeenShip::Vertex, radiance));
    float_attribute(vertex_array_.name(), 2, 1, GL_FLOAT, GL_FALSE, offsetof(SeenShip::Vertex, object));
}

std::int64_t ShipPass::draw(const std::vector<SeenShip>& ships, const TilePlan& plan, const glm::dmat3& axis_from_world,
                            const std::optional<LightSettings>& light) {
    if (ships.empty()) {
        return 0;
    }
    if (!light_) {
        create();
    }
    const GLuint program = (light ? light_ : data_).name();
    glUseProgram(program);
    glUniform1f(near_plane, near_distance);
    if (light) {
        glUniform1f(gain_factor, light->gain);
        glUniform1f(coverage_alpha, light->coverage);
    }
    use_reversed_depth();
    glBindVertexArray(vertex_array_.name());
    std::int64_t triangles = 0;
    for (const SeenShip& ship : ships) {
        const Buffer vertices = make_buffer(ship.vertices);
        const Buffer indices = make_buffer(ship.indices);
        glVertexArrayVertexBuffer(vertex_array_.name(), 0, vertices.name(), 0, sizeof(SeenShip::Vertex));
        glVertexArrayElementBuffer(vertex_array_.name(), indices.name());
        for (const Tile& tile : plan.tiles) {
            const glm::dmat3 texels_from_world = tile.texels_from_axis * axis_from_world;
            if (!reaches(texels_from_world, glm::dvec2(tile.size), ship)) {
                continue;
            }
            glViewport(tile.atlas_corner.x, tile.atlas_corner.y, tile.size.x, tile.size.y);
            const glm::mat3 picture(picture_of_tile(tile, axis_from_world));
            glUniformMatrix3fv(picture_from_world, 1, GL_FALSE, glm::value_ptr(picture));
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(ship.indices.size()), GL_UNSIGNED_INT, nullptr);
            triangles += static_cast<std::int64_t>(ship.indices.size() / 3);
        }
    }
    leave_scene_state();
    return triangles;
}

} // namespace render

#pragma once

#include "render/gl/gl_objects.h"
#include "render/gl/scene_chunks.h"
#include "render/gl/tile_planner.h"
#include "render/render_frame.h"

#include <epoxy/gl.h>
#include <glm/matrix.hpp>

#include <cstddef>
#include <string>
#include <vector>

/// What the parts of ScenePass share: bindings, preprocessor lines, depth state.
namespace render {

inline constexpr auto near_distance = static_cast<float>(nearest_depth);

/// Bindings that the scene's shaders share.
enum Location : GLint {
    picture_from_world = 0,
    eye_position = 1,
    eye_remainder = 2,
    near_plane = 3,
    towards_sun = 4,
    shadow_from_world = 5,
    shadow_offset = 6,
    sun_light = 7,
    gain_factor = 8,
    coverage_alpha = 9,
    along_motion = 10,
    exp_rapidity = 11,
    colour_scale_and_offset = 12,
};
inline constexpr GLuint base_colour_unit = 0;
inline constexpr GLuint emission_unit = 1;
inline constexpr GLuint shadow_unit = 2;
inline constexpr GLuint colour_table_unit = 3;
inline constexpr GLuint lamp_shadow_unit = 4;

/// Preprocessor lines for a kind's shaders.
class Defines {
  public:
    void add(bool condition, const std::string& name) {
        if (condition) {
            text_ += "#define " + name + "\n";
        }
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

inline std::string data_defines(const ChunkKind& kind) {
    Defines defines;
    defines.add(kind.base_colour_array >= 0, "TEXTURED");
    defines.add(kind.masked, "MASKED");
    return defines.text();
}

/// A buffer that keeps its values.
template <class Value>
Buffer make_buffer(const std::vector<Value>& values) {
    Buffer buffer = Buffer::create();
    if (!values.empty()) {
        glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), 0);
    }
    return buffer;
}

/// One attribute of floats, from binding 0.
inline void float_attribute(GLuint array, GLuint location, GLint components, GLenum type, GLboolean normalised,
                            std::size_t offset) {
    glEnableVertexArrayAttrib(array, location);
    glVertexArrayAttribFormat(array, location, components, type, normalised, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, location, 0);
}

/// The map from world directions to a tile's clip coordinates, for scene_clip.
inline glm::dmat3 picture_of_tile(const Tile& tile, const glm::dmat3& axis_from_world) {
    const glm::dvec2 size(tile.size);
    glm::dmat3 rows = glm::transpose(tile.texels_from_axis * axis_from_world);
    rows[0] = rows[0] * (2.0 / size.x) - rows[2];
    rows[1] = rows[1] * (2.0 / size.y) - rows[2];
    return glm::transpose(rows);
}

/// Depth state for pictures with reversed depth: nearer is greater.
inline void use_reversed_depth() {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
}

inline void leave_scene_state() {
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindVertexArray(0);
}

} // namespace render

#pragma once

#include "content/scene_desc.h"
#include "render/gl/chunk_culler.h"
#include "render/gl/gl_objects.h"
#include "render/gl/scene_chunks.h"
#include "render/gl/tile_planner.h"

#include <cstdint>
#include <vector>

namespace render {

/// The scene in OpenGL: draws pictures of the world at rest.
class ScenePass {
  public:
    /// Uploads everything and draws the sun's shadow map, `shadow_map_size` texels a side.
    ScenePass(const content::SceneDesc& scene, int shadow_map_size);

    /// Draws each tile's picture from `eye` (scene metres, world) at its place in the bound framebuffer, over what is
    /// there: radiance times `gain`, alpha `coverage`. Returns the triangles submitted.
    std::int64_t draw_light(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye, float gain,
                            float coverage);

    /// The same, with (distance from the eye in metres, object index) instead of light.
    std::int64_t draw_data(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye);

  private:
    struct KindPrograms {
        Program light;
        Program data;
        Program shadow;
        GLuint base_colours = 0;
        GLuint emissions = 0;
    };

    void upload_geometry();
    void upload_images(const content::SceneDesc& scene);
    void upload_lamps(const content::SceneDesc& scene);
    void make_programs();
    void draw_shadow_map(int size);
    void bind() const;
    void set_view(const Program& program, const glm::dvec3& eye, float gain, float coverage) const;
    std::int64_t draw_tiles(const TilePlan& plan, const glm::dmat3& axis_from_world, Program KindPrograms::*program);
    std::int64_t draw_chunks(const std::vector<std::uint32_t>& chunks, const glm::dmat3& picture_from_world,
                             Program KindPrograms::*program);

    ChunkedScene scene_;
    ChunkCuller culler_;
    std::vector<KindPrograms> kinds_;
    std::vector<Texture> image_arrays_;
    Buffer vertices_;
    Buffer indices_;
    Buffer materials_;
    Buffer lamps_;
    Buffer lamp_indices_;
    VertexArray vertex_array_;
    bool sun_ = false;
    glm::vec3 towards_sun_{0.0f, 1.0f, 0.0f};
    glm::vec3 sun_light_{0.0f};
    Box casters_; ///< of the sun's shadows
    glm::mat4x3 shadow_from_world_{0.0f};
    float shadow_offset_ = 0.0f;
    Texture shadow_map_;
    std::vector<std::vector<GLsizei>> counts_;            ///< by kind, for one multi-draw
    std::vector<std::vector<const void*>> first_indices_; ///< by kind, as byte offsets
};

} // namespace render

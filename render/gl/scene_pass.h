#pragma once

#include "content/scene_desc.h"
#include "render/gl/chunk_culler.h"
#include "render/gl/colour_texture.h"
#include "render/gl/gl_objects.h"
#include "render/gl/scene_chunks.h"
#include "render/gl/tile_planner.h"

#include <cstdint>
#include <vector>

namespace render {

/// How the eye changes the light of the pictures that a ScenePass draws.
struct SeenLightSettings {
    const ColourTexture* colours = nullptr; ///< of the frame
    bool shifted = false;                   ///< false: light as at rest, times `gain`
    double exp_rapidity = 1.0;
    float gain = 1.0f;     ///< the pre-exposure that is in the colours too
    float coverage = 1.0f; ///< alpha of scenery
};

/// The scene in OpenGL: draws pictures of the world in the directions in which it is at rest, in colours as the moving
/// eye sees them.
class ScenePass {
  public:
    /// Uploads everything and draws the shadow maps: the sun's, `shadow_map_size` texels a side, and the lamps'.
    /// Keeps a reference to `spectra`.
    ScenePass(const content::SceneDesc& scene, const SceneSpectra& spectra, int shadow_map_size);

    /// Draws each tile's picture from `eye` (scene metres, world) at its place in the bound framebuffer, over what is
    /// there. Returns the triangles submitted.
    std::int64_t draw_light(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye,
                            const SeenLightSettings& light);

    /// The same, with (distance from the eye in metres, object index) instead of light.
    std::int64_t draw_data(const TilePlan& plan, const glm::dmat3& axis_from_world, const glm::dvec3& eye);

  private:
    struct KindPrograms {
        Program light;   ///< as at rest; made when first needed, as the others
        Program shifted; ///< as the moving eye sees it
        Program data;
        Program lamp_shadow;
        Program shadow;
        GLuint base_colours = 0;
        GLuint emissions = 0;
    };

    void upload_geometry();
    void upload_images(const content::SceneDesc& scene);
    void upload_lamps(const content::SceneDesc& scene);
    void make_programs();
    void draw_shadow_map(int size);
    void draw_lamp_shadows(const content::SceneDesc& scene);
    void make_light_programs(Program KindPrograms::*program, bool shifted);
    void make_data_programs();
    void bind() const;
    void set_view(const Program& program, const glm::dvec3& eye) const;
    void set_light(const Program& program, const glm::dmat3& axis_from_world, const SeenLightSettings& light) const;
    std::int64_t draw_tiles(const TilePlan& plan, const glm::dmat3& axis_from_world, Program KindPrograms::*program);
    std::int64_t draw_chunks(const std::vector<std::uint32_t>& chunks, const glm::dmat3& picture_from_world,
                             Program KindPrograms::*program);

    const SceneSpectra& spectra_;
    ChunkedScene scene_;
    ChunkCuller culler_;
    std::vector<KindPrograms> kinds_;
    std::vector<Texture> image_arrays_;
    Buffer vertices_;
    Buffer indices_;
    Buffer materials_;
    Buffer lamps_;
    Buffer lamp_indices_;
    Buffer hue_wheel_;
    VertexArray vertex_array_;
    bool sun_ = false;
    glm::vec3 towards_sun_{0.0f, 1.0f, 0.0f};
    glm::vec3 sun_light_{0.0f};
    Box casters_; ///< of the sun's shadows
    glm::mat4x3 shadow_from_world_{0.0f};
    float shadow_offset_ = 0.0f;
    Texture shadow_map_;
    Texture lamp_shadows_;
    int lamp_shadow_texels_ = 1;                          ///< along a side of a cube's face
    int shadowed_lamps_ = 0;                              ///< the first so many
    std::vector<std::vector<GLsizei>> counts_;            ///< by kind, for one multi-draw
    std::vector<std::vector<const void*>> first_indices_; ///< by kind, as byte offsets
};

} // namespace render

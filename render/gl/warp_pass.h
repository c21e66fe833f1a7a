#pragma once

#include "content/scene_desc.h"
#include "render/gl/boosted_view.h"
#include "render/gl/colour_texture.h"
#include "render/gl/gl_objects.h"
#include "render/gl/sky_cube.h"
#include "render/gl/tile_planner.h"

#include <cstdint>
#include <optional>

namespace render {

/// What draw_data writes for each pixel; numbers as in shaders/warp_layer.frag.
enum class WarpData : std::uint8_t {
    scenery = 0,   ///< D, distance, object
    direction = 1, ///< unit world direction
    mapping = 2,   ///< D, and where in the atlas the pixel looks, [0, 1]^2
};

/// The second step of the texture method: every pixel of the moving eye from the atlas of tiles, and where there is no
/// scenery the sky, its colour by the frame's table.
class WarpPass {
  public:
    /// `spectra` says where in the frame's colours the microwave background is, if there.
    WarpPass(const content::SceneDesc& scene, const SceneSpectra& spectra);

    /// Prepares a frame: the view's uniforms and the sky's colours.
    void set_frame(const BoostedView& view, const ColourTexture& colours);

    /// Uploads a plan and where its tiles lie in an atlas texture of that size.
    void set_tiles(const TilePlan& plan, const BoostedView& view, const glm::ivec2& atlas_texture_size);

    /// Draws the light seen into the bound framebuffer from an atlas of (light seen, coverage); alpha tells how much
    /// of the sky is to be seen.
    void draw_light(GLuint atlas) const;

    /// Draws data from an atlas of (distance, object), which is not looked at for direction and mapping.
    void draw_data(GLuint atlas, WarpData data) const;

    /// Draws the sky into the bound framebuffer wherever its reversed depth says that nothing is nearer.
    void draw_sky() const;

  private:
    void set_rays(const Program& program, const BoostedView& view) const;
    void bind_frame_light() const;
    void draw_blocks() const;

    std::optional<SkyCube> sky_cube_;
    content::GradientSky gradient_;
    Program warp_;
    Program warp_data_;
    Program sky_;
    GLuint colour_table_ = 0; ///< of the frame
    Buffer tiles_;
    VertexArray no_attributes_;
    GLsizei tile_count_ = 0;
};

} // namespace render

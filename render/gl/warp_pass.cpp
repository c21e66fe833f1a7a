#include "render/gl/warp_pass.h"

#include "render/gl/shader_library.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <string>
#include <vector>

namespace render {
namespace {

enum Location : GLint {
    ray_origin = 0,
    ray_right = 1,
    ray_up = 2,
    exp_rapidity = 3,
    world_from_axis = 4,
    colour_scale_and_offset = 5,
    sky_texels_per_pixel = 6,
    zenith = 7,
    horizon = 8,
    nadir = 9,
    data_wanted = 10,
};
constexpr GLuint atlas_unit = 0;
constexpr GLuint colour_table_unit = 1;
constexpr GLuint sky_unit = 2;

/// One tile as shaders/tile_quad.vert reads it.
struct GpuTile {
    glm::vec4 block;
    glm::vec4 atlas_from_axis[3];
};

} // namespace

WarpPass::WarpPass(const content::SceneDesc& scene, const SceneSpectra& spectra)
    : gradient_(scene.gradient_sky), no_attributes_(VertexArray::create()) {
    if (scene.panorama) {
        sky_cube_.emplace(*scene.panorama);
    }
    std::string defines = sky_cube_ ? "#define PANORAMA\n" : "";
    if (spectra.microwave_background()) {
        const int layer = FrameColourTable(spectra).first_layer[*spectra.microwave_background()];
        defines += "#define MICROWAVE_LAYER " + std::to_string(layer) + "\n";
    }
    warp_ = make_program("tile_quad.vert", "warp.frag", defines);
    sky_ = make_program("fullscreen.vert", "sky.frag", defines);
    warp_data_ = make_program("tile_quad.vert", "warp_layer.frag");
}

void WarpPass::set_frame(const BoostedView& view, const ColourTexture& colours) {
    for (const Program* program : {&warp_, &sky_, &warp_data_}) {
        set_rays(*program, view);
    }
    colour_table_ = colours.name();
    for (const Program* program : {&warp_, &sky_}) {
        const GLuint name = program->name();
        glProgramUniform2fv(name, colour_scale_and_offset, 1, glm::value_ptr(colours.scale_and_offset()));
        glProgramUniform3fv(name, zenith, 1, glm::value_ptr(gradient_.zenith));
        glProgramUniform3fv(name, horizon, 1, glm::value_ptr(gradient_.horizon));
        glProgramUniform3fv(name, nadir, 1, glm::value_ptr(gradient_.nadir));
        if (sky_cube_) {
            const double focal_pixels = 0.5 * view.width / view.half_extent.x;
            glProgramUniform1f(name, sky_texels_per_pixel, sky_cube_->texels_per_pixel(focal_pixels));
        }
    }
}

void WarpPass::set_rays(const Program& program, const BoostedView& view) const {
    const ScreenRays rays = screen_rays(view);
    glProgramUniform3fv(program.name(), ray_origin, 1, glm::value_ptr(rays.origin));
    glProgramUniform3fv(program.name(), ray_right, 1, glm::value_ptr(rays.right));
    glProgramUniform3fv(program.name(), ray_up, 1, glm::value_ptr(rays.up));
    glProgramUniform1f(program.name(), exp_rapidity, rays.exp_rapidity);
    glProgramUniformMatrix3fv(program.name(), world_from_axis, 1, GL_FALSE, glm::value_ptr(rays.world_from_axis));
}

void WarpPass::set_tiles(const TilePlan& plan, const BoostedView& view, const glm::ivec2& atlas_texture_size) {
    std::vector<GpuTile> tiles;
    const glm::dvec2 screen(view.width, view.height);
    const glm::dvec2 atlas(atlas_texture_size);
    for (const Tile& tile : plan.tiles) {
        const glm::dmat3 rows = glm::transpose(tile.texels_from_axis);
        const glm::dvec2 corner(tile.atlas_corner);
        const glm::dvec2 low = 2.0 * glm::dvec2(tile.block_low) / screen - 1.0;
        const glm::dvec2 high = 2.0 * glm::dvec2(tile.block_high) / screen - 1.0;
        const glm::dvec3 x = (rows[0] + corner.x * rows[2]) / atlas.x;
        const glm::dvec3 y = (rows[1] + corner.y * rows[2]) / atlas.y;
        tiles.push_back({glm::vec4(glm::vec2(low), glm::vec2(high)),
                         {glm::vec4(x, 0.0f), glm::vec4(y, 0.0f), glm::vec4(rows[2], 0.0f)}});
    }
    tile_count_ = static_cast<GLsizei>(tiles.size());
    tiles_ = Buffer::create();
    glNamedBufferStorage(tiles_.name(), static_cast<GLsizeiptr>(tiles.size() * sizeof(GpuTile)), tiles.data(), 0);
}

void WarpPass::bind_frame_light() const {
    glBindTextureUnit(colour_table_unit, colour_table_);
    glBindTextureUnit(sky_unit, sky_cube_ ? sky_cube_->texture() : 0);
    glDisable(GL_BLEND);
}

void WarpPass::draw_blocks() const {
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(no_attributes_.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, tiles_.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, tile_count_);
}

void WarpPass::draw_light(GLuint atlas) const {
    glUseProgram(warp_.name());
    glBindTextureUnit(atlas_unit, atlas);
    bind_frame_light();
    draw_blocks();
}

void WarpPass::draw_data(GLuint atlas, WarpData data) const {
    glProgramUniform1i(warp_data_.name(), data_wanted, static_cast<GLint>(data));
    glUseProgram(warp_data_.name());
    glBindTextureUnit(atlas_unit, atlas);
    glDisable(GL_BLEND);
    draw_blocks();
}

void WarpPass::draw_sky() const {
    glUseProgram(sky_.name());
    bind_frame_light();
    glBindVertexArray(no_attributes_.name());
    // Depth 0 is infinitely far where depth is reversed; it passes only where nothing was drawn.
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

} // namespace render

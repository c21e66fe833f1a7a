#include "render/gl/warp_error.h"

#include "render/eye_ray.h"
#include "render/gl/render_target.h"
#include "render/gl/tile_planner.h"
#include "render/gl/warp_pass.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace render {
namespace {

constexpr int atlas_limit = 8192;

std::vector<glm::vec4> mapping_on_gpu(const BoostedView& view, const TilePlan& plan) {
    const content::SceneDesc empty;
    const SceneSpectra spectra(empty);
    WarpPass warp(empty, spectra);
    const ColourTexture colours(spectra);
    warp.set_frame(view, colours);
    warp.set_tiles(plan, view, plan.atlas_size);
    RenderTarget screen(GL_RGBA32F, GL_NEAREST, false);
    screen.resize({view.width, view.height});
    glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer());
    glViewport(0, 0, view.width, view.height);
    warp.draw_data(0, WarpData::mapping);
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

} // namespace

WarpError warp_error(const EyeView& eye) {
    const BoostedView view = boosted_view(eye);
    // At sharpness 1 a pixel has at least one texel in every direction: errors in texels bound those in pixels.
    const TilePlan plan = plan_tiles(view, 1.0, atlas_limit);
    const std::vector<glm::vec4> mapped = mapping_on_gpu(view, plan);
    WarpError error;
    for (const Tile& tile : plan.tiles) {
        for (int y = tile.block_low.y; y < tile.block_high.y; ++y) {
            for (int x = tile.block_low.x; x < tile.block_high.x; ++x) {
                const sim::SeenLight exact =
                    sim::see(eye.world_from_head, head_direction_from_pixel(eye, x + 0.5, eye.height - y - 0.5));
                const glm::dvec3 h = tile.texels_from_axis * (view.axis_from_world * exact.world_direction);
                const glm::dvec2 wanted = glm::dvec2(h) / h.z + glm::dvec2(tile.atlas_corner);
                const glm::vec4& gpu = mapped[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
                                              static_cast<std::size_t>(x)];
                const glm::dvec2 got = glm::dvec2(gpu.y, gpu.z) * glm::dvec2(plan.atlas_size);
                const double pixels = glm::distance(got, wanted);
                if (!(pixels <= error.pixels)) { // so that a NaN shows
                    error.pixels = pixels;
                    error.worst_pixel = {x, y};
                }
                const double relative = std::abs(static_cast<double>(gpu.x) / exact.wavelength_ratio - 1.0);
                error.relative_d = std::max(error.relative_d, relative);
            }
        }
    }
    return error;
}

} // namespace render

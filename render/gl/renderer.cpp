#include "render/gl/renderer.h"

#include "render/gl/boosted_view.h"
#include "render/gl/display_pass.h"
#include "render/gl/egl_context.h"
#include "render/gl/ray_pass.h"
#include "render/gl/render_target.h"
#include "render/gl/scene_pass.h"
#include "render/gl/ship_pass.h"
#include "render/gl/software_opengl.h"
#include "render/gl/stage_clock.h"
#include "render/gl/star_layer.h"
#include "render/gl/tile_planner.h"
#include "render/gl/warp_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace render {
namespace {

/// Slower than this the picture at rest is the same to a twentieth of a pixel.
constexpr double rest_rapidity = 1e-4;
constexpr int atlas_limit = 8192;
constexpr double middle_grey = 0.25;

int largest_atlas() {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    return std::min(limit, atlas_limit);
}

/// Reads the lower left part of a float texture's framebuffer, rows from the top, `channels` of four from `first`.
Picture read_back(GLuint framebuffer, int width, int height, int first, int channels) {
    Picture picture{width, height, channels, {}};
    const auto row = static_cast<std::size_t>(width);
    std::vector<float> pixels(4 * row * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, pixels.data());
    picture.values.reserve(row * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels));
    for (int y = height - 1; y >= 0; --y) {
        for (std::size_t x = 0; x < row; ++x) {
            const float* pixel = &pixels[4 * (static_cast<std::size_t>(y) * row + x)];
            picture.values.insert(picture.values.end(), pixel + first, pixel + first + channels);
        }
    }
    return picture;
}

} // namespace

class Renderer::Implementation {
  public:
    Implementation(content::SceneDesc scene, const RendererSettings& settings) : settings_(settings), colour_(scene) {
        if (settings_.method == Method::automatic && software_opengl()) {
            settings_.method = Method::ray;
        }
        if (settings_.method == Method::ray) {
            rays_.emplace(std::move(scene), colour_);
        } else {
            raster_.emplace(scene, settings_.shadow_map_size, colour_);
        }
    }

    void draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport, StereoShare* share) {
        const double pre_exposure = draw_light(frame, screen_, share);
        StageClock clock(settings_.measure_stages);
        const double factor = share != nullptr && share->factor ? *share->factor : factor_of(frame, pre_exposure);
        if (share != nullptr) {
            share->factor = factor;
        }
        if (rays_ && RayPass::shows(frame.display)) {
            rays_->show(frame, factor / pre_exposure, target_framebuffer, viewport);
        } else {
            if (rays_) {
                screen_.resize({frame.eye.width, frame.eye.height});
                rays_->load(screen_);
            }
            display_.draw(frame, screen_.colour(), factor / pre_exposure, target_framebuffer, viewport);
        }
        statistics_.exposure_stops = std::log2(factor);
        statistics_.display = clock.lap();
    }

    bool copy_depth(GLuint texture) const {
        if (!depth_kept_) {
            return false;
        }
        if (rays_) {
            rays_->copy_depth(texture);
        } else {
            const glm::ivec2 size = screen_.size();
            glCopyImageSubData(screen_.depth(), GL_TEXTURE_2D, 0, 0, 0, 0, texture, GL_TEXTURE_2D, 0, 0, 0, 0, size.x,
                               size.y, 1);
        }
        return true;
    }

    Picture picture(const RenderFrame& frame) {
        if (frame.layer != Layer::light && rays_) {
            start_statistics(Method::ray);
            return rays_->layer(frame);
        }
        const int width = frame.eye.width;
        const int height = frame.eye.height;
        if (frame.layer != Layer::light) {
            draw_data(frame);
            const bool direction = frame.layer == Layer::direction;
            const int channel = frame.layer == Layer::distance ? 1 : (frame.layer == Layer::object ? 2 : 0);
            return read_back(raster_->data_screen.framebuffer(), width, height, channel, direction ? 3 : 1);
        }
        const double pre_exposure = draw_light(frame, screen_);
        const double factor = factor_of(frame, pre_exposure);
        statistics_.exposure_stops = std::log2(factor);
        if (rays_) {
            return rays_->picture(static_cast<float>(factor / pre_exposure));
        }
        Picture result = read_back(screen_.framebuffer(), width, height, 0, 3);
        const auto remaining = static_cast<float>(factor / pre_exposure);
        for (float& value : result.values) {
            value *= remaining;
        }
        return result;
    }

    Picture small_picture(const RenderFrame& frame) {
        const FrameStatistics of_main_picture = statistics_;
        draw_light(frame, small_screen_); // the pre-exposure is all of a manual exposure
        statistics_ = of_main_picture;
        if (rays_) {
            return rays_->picture(1.0f);
        }
        return read_back(small_screen_.framebuffer(), frame.eye.width, frame.eye.height, 0, 3);
    }

    const FrameStatistics& statistics() const { return statistics_; }

  private:
    /// What the texture method and the plain one draw with.
    struct Raster {
        Raster(const content::SceneDesc& scene_desc, int shadow_map_size, const SceneColour& colour)
            : colours(colour.spectra()), scene(scene_desc, colour.spectra(), shadow_map_size), surroundings(scene_desc),
              warp(scene_desc, colour.spectra()), stars(scene_desc, colour.doppler()) {}
        ColourTexture colours;
        ScenePass scene;
        Surroundings surroundings;
        ShipPass ships;
        WarpPass warp;
        StarLayer stars;
        RenderTarget atlas{GL_RGBA16F, GL_LINEAR, true};
        RenderTarget data_atlas{GL_RG32F, GL_NEAREST, true};
        RenderTarget data_screen{GL_RGBA32F, GL_NEAREST, false};
    };

    void start_statistics(Method method) {
        statistics_ = {};
        statistics_.method = method;
    }

    bool at_rest(const BoostedView& view) const {
        return settings_.method == Method::plain ||
               (settings_.method == Method::automatic && view.rapidity < rest_rapidity);
    }

    /// Luminance of a white surface in the direction of looking, as the mode shows it.
    double luminance_ahead(const RenderFrame& frame, const BoostedView& view) const {
        const double d = glm::length(
            view.direction_times_ratio(0.5 * glm::dvec2(view.width, view.height) + frame.eye.axis_from_middle));
        const glm::dvec3 white =
            colour_.doppler().matrix(frame.mode, std::log(std::clamp(d, 1e-4, 1e4))) * glm::dvec3(1.0);
        return middle_grey * std::max(glm::dot(white, glm::dvec3(0.2126, 0.7152, 0.0722)), 0.0);
    }

    /// The whole factor on radiance for the light drawn last.
    double factor_of(const RenderFrame& frame, double pre_exposure) {
        if (!rays_) {
            return display_.factor(frame, screen_.colour(), pre_exposure);
        }
        return display_.factor(frame, frame.exposure.automatic ? rays_->metered(pre_exposure) : MeteredLight{});
    }

    /// Fills `screen`, or the packets of rays, with the light times the pre-exposure that it returns.
    double draw_light(const RenderFrame& frame, RenderTarget& screen, StereoShare* share = nullptr) {
        StageClock clock(settings_.measure_stages);
        const BoostedView view = boosted_view(frame.eye);
        const double pre_exposure = share != nullptr && share->pre_exposure
                                        ? *share->pre_exposure
                                        : display_.pre_exposure(frame, luminance_ahead(frame, view));
        if (share != nullptr) {
            share->pre_exposure = pre_exposure;
        }
        if (rays_) {
            cast_light(frame, view, pre_exposure, clock, share);
        } else {
            screen.resize({frame.eye.width, frame.eye.height});
            rasterise_light(frame, screen, view, pre_exposure, clock);
            raster_->stars.draw(frame, sim::split(frame.eye.world_from_head), pre_exposure, share);
        }
        statistics_.stars = clock.lap();
        return pre_exposure;
    }

    void cast_light(const RenderFrame& frame, const BoostedView& view, double pre_exposure, StageClock& clock,
                    StereoShare* share) {
        start_statistics(Method::ray);
        statistics_.texels_per_pixel = 1.0;
        depth_kept_ = frame.keep_depth && view.rapidity < rest_rapidity;
        rays_->cast(frame, pre_exposure, share, depth_kept_);
        statistics_.scene = clock.lap();
        rays_->add_stars(frame, pre_exposure, share);
    }

    void rasterise_light(const RenderFrame& frame, const RenderTarget& screen, BoostedView view, double pre_exposure,
                         StageClock& clock) {
        const bool rest = at_rest(view);
        if (rest) {
            view.exp_rapidity = 1.0;
        }
        const RatioRange range = ratio_range(view, glm::dvec2(0.0), glm::dvec2(view.width, view.height));
        raster_->colours.upload(frame_colour_table(colour_, frame.mode, range.least, range.most, pre_exposure));
        raster_->warp.set_frame(view, raster_->colours);
        const TilePlan plan = make_plan(view, rest, frame.sharpness);
        statistics_.plan = clock.lap();
        depth_kept_ = rest;
        if (rest) {
            draw_at_rest(frame, screen, view, plan, pre_exposure, clock);
        } else {
            draw_tiles_and_warp(frame, screen, view, plan, pre_exposure, clock);
        }
    }

    TilePlan make_plan(const BoostedView& view, bool rest, double sharpness) {
        TilePlan plan = rest ? plan_plain(view) : plan_tiles(view, sharpness, largest_atlas_);
        start_statistics(rest ? Method::plain : Method::texture);
        statistics_.tiles = static_cast<int>(plan.tiles.size());
        statistics_.texels_per_pixel = plan.texels_per_pixel;
        statistics_.sharpness = plan.sharpness;
        return plan;
    }

    std::int64_t draw_ships(const RenderFrame& frame, const TilePlan& plan, const BoostedView& view,
                            const std::optional<ShipPass::LightSettings>& light) {
        if (frame.moving.ships.empty()) {
            return 0;
        }
        return raster_->ships.draw(see_ships(frame, raster_->surroundings, colour_.doppler()), plan,
                                   view.axis_from_world, light);
    }

    void draw_at_rest(const RenderFrame& frame, const RenderTarget& screen, const BoostedView& view,
                      const TilePlan& plan, double pre_exposure, StageClock& clock) {
        clear(screen, {0.0f, 0.0f, 0.0f, 0.0f});
        statistics_.triangles =
            raster_->scene.draw_light(plan, view.axis_from_world, frame.eye.position,
                                      {&raster_->colours, false, 1.0, static_cast<float>(pre_exposure), 0.0f});
        statistics_.triangles +=
            draw_ships(frame, plan, view, ShipPass::LightSettings{static_cast<float>(pre_exposure), 0.0f});
        statistics_.scene = clock.lap();
        raster_->warp.draw_sky();
        statistics_.warp = clock.lap();
    }

    void draw_tiles_and_warp(const RenderFrame& frame, const RenderTarget& screen, const BoostedView& view,
                             const TilePlan& plan, double pre_exposure, StageClock& clock) {
        raster_->atlas.grow(plan.atlas_size);
        clear(raster_->atlas, {0.0f, 0.0f, 0.0f, 0.0f});
        statistics_.triangles = raster_->scene.draw_light(plan, view.axis_from_world, frame.eye.position,
                                                          {&raster_->colours, frame.mode != Mode::geometry,
                                                           view.exp_rapidity, static_cast<float>(pre_exposure), 1.0f});
        statistics_.triangles +=
            draw_ships(frame, plan, view, ShipPass::LightSettings{static_cast<float>(pre_exposure), 1.0f});
        statistics_.scene = clock.lap();
        raster_->warp.set_tiles(plan, view, raster_->atlas.size());
        glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer());
        glViewport(0, 0, view.width, view.height);
        raster_->warp.draw_light(raster_->atlas.colour());
        statistics_.warp = clock.lap();
    }

    void draw_data(const RenderFrame& frame) {
        BoostedView view = boosted_view(frame.eye);
        const bool rest = at_rest(view);
        if (rest) {
            view.exp_rapidity = 1.0;
        }
        raster_->data_screen.resize({frame.eye.width, frame.eye.height});
        raster_->warp.set_frame(view, raster_->colours);
        const TilePlan plan = make_plan(view, rest, frame.sharpness);
        raster_->data_atlas.grow(plan.atlas_size);
        clear(raster_->data_atlas, {std::numeric_limits<float>::infinity(), -1.0f, 0.0f, 0.0f});
        statistics_.triangles = raster_->scene.draw_data(plan, view.axis_from_world, frame.eye.position);
        statistics_.triangles += draw_ships(frame, plan, view, std::nullopt);
        raster_->warp.set_tiles(plan, view, raster_->data_atlas.size());
        glBindFramebuffer(GL_FRAMEBUFFER, raster_->data_screen.framebuffer());
        glViewport(0, 0, view.width, view.height);
        raster_->warp.draw_data(raster_->data_atlas.colour(),
                                frame.layer == Layer::direction ? WarpData::direction : WarpData::scenery);
    }

    static void clear(const RenderTarget& target, const std::array<float, 4>& colour) {
        const float infinitely_far = 0.0f; // depth is reversed
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
        glDepthMask(GL_TRUE);
        glClearBufferfv(GL_COLOR, 0, colour.data());
        glClearBufferfv(GL_DEPTH, 0, &infinitely_far);
    }

    RendererSettings settings_;
    SceneColour colour_;
    int largest_atlas_ = largest_atlas();
    DisplayPass display_;
    RenderTarget screen_{GL_RGBA16F, GL_NEAREST, true};
    RenderTarget small_screen_{GL_RGBA16F, GL_NEAREST, true};
    std::optional<Raster> raster_; ///< one of these two
    std::optional<RayPass> rays_;
    FrameStatistics statistics_;
    bool depth_kept_ = false; ///< of the last draw
};

Renderer::Renderer(content::SceneDesc scene, const RendererSettings& settings) {
    require_opengl_45();
    implementation_ = std::make_unique<Implementation>(std::move(scene), settings);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

FrameStatistics Renderer::draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport,
                               StereoShare* share) {
    implementation_->draw(frame, target_framebuffer, viewport, share);
    return statistics();
}

bool Renderer::copy_depth(unsigned depth_texture) const {
    return implementation_->copy_depth(depth_texture);
}

Picture Renderer::picture(const RenderFrame& frame) {
    return implementation_->picture(frame);
}

Picture Renderer::small_picture(const RenderFrame& frame) {
    return implementation_->small_picture(frame);
}

const FrameStatistics& Renderer::statistics() const {
    return implementation_->statistics();
}

} // namespace render

#include "render/gl/renderer.h"

#include "render/gl/boosted_view.h"
#include "render/gl/display_pass.h"
#include "render/gl/egl_context.h"
#include "render/gl/render_target.h"
#include "render/gl/scene_pass.h"
#include "render/gl/stage_clock.h"
#include "render/gl/star_layer.h"
#include "render/gl/tile_planner.h"
#include "render/gl/warp_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace render {
namespace {

/// Slower than this the picture at rest is the same to a twentieth of a pixel.
constexpr double rest_rapidity = 1e-4;
constexpr int atlas_limit = 8192;
/// Data layers look up the nearest texel; with these many a pixel, an edge is placed within half a pixel.
constexpr double data_sharpness = 1.5;
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
    Implementation(const content::SceneDesc& scene, const RendererSettings& settings)
        : settings_(settings), colour_(static_cast<double>(scene.light_temperature)),
          scene_(scene, settings.shadow_map_size), warp_(scene, colour_), stars_(scene, colour_) {}

    void draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport) {
        const double pre_exposure = draw_light(frame);
        StageClock clock(settings_.measure_stages);
        const double factor = display_.factor(frame, screen_.colour(), pre_exposure);
        display_.draw(frame, screen_.colour(), factor / pre_exposure, target_framebuffer, viewport);
        statistics_.exposure_stops = std::log2(factor);
        statistics_.display = clock.lap();
    }

    Picture picture(const RenderFrame& frame) {
        const int width = frame.eye.width;
        const int height = frame.eye.height;
        if (frame.layer != Layer::light) {
            draw_data(frame);
            const bool direction = frame.layer == Layer::direction;
            const int channel = frame.layer == Layer::distance ? 1 : (frame.layer == Layer::object ? 2 : 0);
            return read_back(data_screen_.framebuffer(), width, height, channel, direction ? 3 : 1);
        }
        const double pre_exposure = draw_light(frame);
        const double factor = display_.factor(frame, screen_.colour(), pre_exposure);
        statistics_.exposure_stops = std::log2(factor);
        Picture result = read_back(screen_.framebuffer(), width, height, 0, 3);
        const auto remaining = static_cast<float>(factor / pre_exposure);
        for (float& value : result.values) {
            value *= remaining;
        }
        return result;
    }

    const FrameStatistics& statistics() const { return statistics_; }

  private:
    bool at_rest(const BoostedView& view) const {
        return settings_.method == Method::plain ||
               (settings_.method == Method::automatic && view.rapidity < rest_rapidity);
    }

    /// Luminance of a white surface in the direction of looking, as the mode shows it.
    double luminance_ahead(const RenderFrame& frame, const BoostedView& view) const {
        const double d = glm::length(view.direction_times_ratio(0.5 * glm::dvec2(view.width, view.height)));
        const glm::dvec3 white = colour_.matrix(frame.mode, std::log(std::clamp(d, 1e-4, 1e4))) * glm::dvec3(1.0);
        return middle_grey * std::max(glm::dot(white, glm::dvec3(0.2126, 0.7152, 0.0722)), 0.0);
    }

    /// Fills screen_ with the light times the pre-exposure that it returns.
    double draw_light(const RenderFrame& frame) {
        StageClock clock(settings_.measure_stages);
        BoostedView view = boosted_view(frame.eye);
        statistics_ = {};
        const bool rest = at_rest(view);
        if (rest) {
            view.exp_rapidity = 1.0;
        }
        const double pre_exposure = display_.pre_exposure(frame.exposure, luminance_ahead(frame, view));
        screen_.resize({frame.eye.width, frame.eye.height});
        warp_.set_frame(view, frame.mode, pre_exposure);
        const TilePlan plan = make_plan(view, rest, frame.sharpness);
        statistics_.plan = clock.lap();
        if (rest) {
            draw_at_rest(frame, view, plan, pre_exposure, clock);
        } else {
            draw_tiles_and_warp(frame, view, plan, clock);
        }
        stars_.draw(frame, sim::split(frame.eye.world_from_head), pre_exposure);
        statistics_.stars = clock.lap();
        return pre_exposure;
    }

    TilePlan make_plan(const BoostedView& view, bool rest, double sharpness) {
        TilePlan plan = rest ? plan_plain(view) : plan_tiles(view, sharpness, largest_atlas_);
        statistics_.method = rest ? Method::plain : Method::texture;
        statistics_.tiles = static_cast<int>(plan.tiles.size());
        statistics_.texels_per_pixel = plan.texels_per_pixel;
        statistics_.sharpness = plan.sharpness;
        return plan;
    }

    void draw_at_rest(const RenderFrame& frame, const BoostedView& view, const TilePlan& plan, double pre_exposure,
                      StageClock& clock) {
        clear(screen_, {0.0f, 0.0f, 0.0f, 0.0f});
        statistics_.triangles =
            scene_.draw_light(plan, view.axis_from_world, frame.eye.position, static_cast<float>(pre_exposure), 0.0f);
        statistics_.scene = clock.lap();
        warp_.draw_sky();
        statistics_.warp = clock.lap();
    }

    void draw_tiles_and_warp(const RenderFrame& frame, const BoostedView& view, const TilePlan& plan,
                             StageClock& clock) {
        atlas_.grow(plan.atlas_size);
        clear(atlas_, {0.0f, 0.0f, 0.0f, 0.0f});
        statistics_.triangles = scene_.draw_light(plan, view.axis_from_world, frame.eye.position, 1.0f, 1.0f);
        statistics_.scene = clock.lap();
        warp_.set_tiles(plan, view, atlas_.size());
        glBindFramebuffer(GL_FRAMEBUFFER, screen_.framebuffer());
        glViewport(0, 0, view.width, view.height);
        warp_.draw_light(atlas_.colour());
        statistics_.warp = clock.lap();
    }

    void draw_data(const RenderFrame& frame) {
        BoostedView view = boosted_view(frame.eye);
        statistics_ = {};
        const bool rest = at_rest(view);
        if (rest) {
            view.exp_rapidity = 1.0;
        }
        data_screen_.resize({frame.eye.width, frame.eye.height});
        warp_.set_frame(view, frame.mode, 1.0);
        const TilePlan plan = make_plan(view, rest, std::max(frame.sharpness, data_sharpness));
        data_atlas_.grow(plan.atlas_size);
        clear(data_atlas_, {std::numeric_limits<float>::infinity(), -1.0f, 0.0f, 0.0f});
        statistics_.triangles = scene_.draw_data(plan, view.axis_from_world, frame.eye.position);
        warp_.set_tiles(plan, view, data_atlas_.size());
        glBindFramebuffer(GL_FRAMEBUFFER, data_screen_.framebuffer());
        glViewport(0, 0, view.width, view.height);
        warp_.draw_data(data_atlas_.colour(),
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
    DopplerColour colour_;
    int largest_atlas_ = largest_atlas();
    ScenePass scene_;
    WarpPass warp_;
    StarLayer stars_;
    DisplayPass display_;
    RenderTarget atlas_{GL_RGBA16F, GL_LINEAR, true};
    RenderTarget screen_{GL_RGBA16F, GL_NEAREST, true};
    RenderTarget data_atlas_{GL_RG32F, GL_NEAREST, true};
    RenderTarget data_screen_{GL_RGBA32F, GL_NEAREST, false};
    FrameStatistics statistics_;
};

Renderer::Renderer(const content::SceneDesc& scene, const RendererSettings& settings) {
    require_opengl_45();
    implementation_ = std::make_unique<Implementation>(scene, settings);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

FrameStatistics Renderer::draw(const RenderFrame& frame, unsigned target_framebuffer, const Viewport& viewport) {
    implementation_->draw(frame, target_framebuffer, viewport);
    return statistics();
}

Picture Renderer::picture(const RenderFrame& frame) {
    return implementation_->picture(frame);
}

const FrameStatistics& Renderer::statistics() const {
    return implementation_->statistics();
}

} // namespace render

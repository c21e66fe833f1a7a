#include "engine/commands/bench.h"

#include "content/scenario.h"
#include "engine/median.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "sim/look.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <vector>

namespace engine {
namespace {

struct Options {
    std::string scene = "lattice";
    std::string size = "1280x720";
    std::string rounds = "5";
    std::string sharpness = "1";
};

render::StageCost total(const render::FrameStatistics& s) {
    render::StageCost sum;
    for (const render::StageCost& stage : {s.plan, s.scene, s.warp, s.stars, s.display}) {
        sum.wall_ms += stage.wall_ms;
        sum.cpu_ms += stage.cpu_ms;
    }
    return sum;
}

/// What frames of one kind cost, round by round.
class FrameCosts {
  public:
    void add(const render::FrameStatistics& statistics) {
        const render::StageCost sum = total(statistics);
        cpu_.push_back(sum.cpu_ms);
        wall_.push_back(sum.wall_ms);
        stages_.push_back({statistics.plan.cpu_ms, statistics.scene.cpu_ms, statistics.warp.cpu_ms,
                           statistics.stars.cpu_ms, statistics.display.cpu_ms});
        last_ = statistics;
    }

    double cpu_ms() const { return median(cpu_); }
    double wall_ms() const { return median(wall_); }
    double stage_ms(std::size_t stage) const {
        std::vector<double> values;
        for (const auto& round : stages_) {
            values.push_back(round.at(stage));
        }
        return median(values);
    }
    /// Median over the rounds of this cost to another's of the same round.
    double ratio_to(const FrameCosts& other) const {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < cpu_.size(); ++i) {
            ratios.push_back(cpu_[i] / other.cpu_[i]);
        }
        return median(ratios);
    }
    const render::FrameStatistics& last() const { return last_; }

  private:
    std::vector<double> cpu_;
    std::vector<double> wall_;
    std::vector<std::array<double, 5>> stages_;
    render::FrameStatistics last_;
};

/// Draws frames of one scenario by both methods and keeps what they cost.
class FrameBench {
  public:
    FrameBench(const content::Scenario& scenario, const PictureSize& size, int rounds, double sharpness)
        : scenario_(scenario), target_(size.width, size.height), rounds_(rounds),
          plain_(content::load_scene(scenario), settings(render::Method::plain)),
          texture_(content::load_scene(scenario), settings(render::Method::texture)),
          ray_(content::load_scene(scenario), settings(render::Method::ray)) {
        frame_.eye.position = scenario.start_position;
        frame_.eye.horizontal_field_of_view = scenario.horizontal_field_of_view;
        frame_.eye.width = size.width;
        frame_.eye.height = size.height;
        frame_.exposure = {scenario.exposure.automatic, static_cast<float>(scenario.exposure.stops), false};
        frame_.sharpness = sharpness;
    }

    void print_header() const {
        fmt::print(
            "{} {}x{}, sharpness {:.2f} (of texture; ray casts each pixel), medians of {} interleaved rounds\n"
            "ms of CPU time, all threads, except wall; an ordinary frame is the same eye at rest: drawn by OpenGL, "
            "or by rays\n"
            "ratios: moving to the ordinary frame of OpenGL, and of rays to the ordinary frame of rays\n",
            scenario_.name, target_.width(), target_.height(), frame_.sharpness, rounds_);
        fmt::print("{:12} | {:^13} | {:^21} | {:^28} | {:^50} | {:^15}\n", "", "ordinary", "texture, moving",
                   "ray, moving", "of texture: plan, tiles, warp, stars, display", "of ray: cast, rest");
        fmt::print("{:>5} {:6} | {:>6} {:>6} | {:>7} {:>6} {:>6} | {:>7} {:>6} {:>6} {:>6} | {:>6} {:>6} {:>6} {:>6} "
                   "{:>6} {:>5} {:>8} | {:>7} {:>7}\n",
                   "beta", "view", "OpenGL", "rays", "ms", "ratio", "wall", "ms", "ratio", "ratio", "wall", "plan",
                   "tiles", "warp", "stars", "displ", "tiles", "texel/px", "cast", "rest");
    }

    /// One row: `heading_in_eye` is the direction of motion in the eye's axes.
    void measure(double beta, const std::string& view, const glm::dvec3& heading_in_eye) {
        const glm::dvec3 look = glm::normalize(scenario_.start_look);
        const auto at_rest = sim::world_from_looking<sim::Head>(sim::Rapidity(0.0), look, look);
        const glm::dvec3 heading = (at_rest * sim::FourVector<sim::Head>{0.0, heading_in_eye}).space;
        const auto moving = sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), heading, look);
        FrameCosts plain;
        FrameCosts texture;
        FrameCosts ray_at_rest;
        FrameCosts ray;
        for (int round = -1; round < rounds_; ++round) {
            frame_.eye.world_from_head = at_rest;
            const render::FrameStatistics of_plain = draw(plain_);
            const render::FrameStatistics of_ray_at_rest = draw(ray_);
            frame_.eye.world_from_head = moving;
            const render::FrameStatistics of_texture = draw(texture_);
            const render::FrameStatistics of_ray = draw(ray_);
            if (round < 0) {
                continue; // only warms up
            }
            plain.add(of_plain);
            ray_at_rest.add(of_ray_at_rest);
            texture.add(of_texture);
            ray.add(of_ray);
        }
        fmt::print("{:5.3f} {:6} | {:6.1f} {:6.1f} | {:7.1f} {:6.2f} {:6.1f} | {:7.1f} {:6.2f} {:6.2f} {:6.1f} | ",
                   beta, view, plain.cpu_ms(), ray_at_rest.cpu_ms(), texture.cpu_ms(), texture.ratio_to(plain),
                   texture.wall_ms(), ray.cpu_ms(), ray.ratio_to(plain), ray.ratio_to(ray_at_rest), ray.wall_ms());
        for (std::size_t stage = 0; stage < 5; ++stage) {
            fmt::print("{:6.1f} ", texture.stage_ms(stage));
        }
        fmt::print("{:5} {:8.2f} | {:7.1f} {:7.1f}\n", texture.last().tiles, texture.last().texels_per_pixel,
                   ray.stage_ms(1), ray.stage_ms(3) + ray.stage_ms(4));
        std::fflush(stdout);
    }

  private:
    static render::RendererSettings settings(render::Method method) {
        render::RendererSettings settings;
        settings.method = method;
        settings.measure_stages = true;
        return settings;
    }

    render::FrameStatistics draw(render::Renderer& renderer) {
        return renderer.draw(frame_, target_.framebuffer(), {0, 0, target_.width(), target_.height()});
    }

    content::Scenario scenario_;
    Offscreen target_;
    int rounds_;
    render::Renderer plain_;
    render::Renderer texture_;
    render::Renderer ray_;
    render::RenderFrame frame_;
};

void bench_frame(const Options& options) {
    const PictureSize size = size_option("--size", options.size);
    const int rounds = whole_number_option("--rounds", options.rounds, 1, 1000);
    const double sharpness = number_option("--sharpness", options.sharpness, 0.25, 2.0);
    const content::Scenario scenario = content::load_scenario(options.scene);
    const render::EglContext context;
    FrameBench bench(scenario, size, rounds, sharpness);
    bench.print_header();
    for (const double beta : {0.5, 0.9, 0.99}) {
        bench.measure(beta, "ahead", {0.0, 0.0, -1.0});
        bench.measure(beta, "aside", {-1.0, 0.0, 0.0});
        bench.measure(beta, "behind", {0.0, 0.0, 1.0});
    }
}

} // namespace

void add_bench_frame(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("frame", "cost of a moving frame against an ordinary one");
    const auto options = std::make_shared<Options>();
    command->add_option("--scene", options->scene, "scenario")->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--rounds", options->rounds, "pairs of frames for each row")->capture_default_str();
    command->add_option("--sharpness", options->sharpness, "least texels a pixel, along each direction")
        ->capture_default_str();
    command->callback([options] { bench_frame(*options); });
}

} // namespace engine

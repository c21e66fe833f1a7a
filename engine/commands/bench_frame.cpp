#include "engine/commands/bench.h"

#include "content/scenario.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "sim/look.h"

#include <algorithm>
#include <array>
#include <cmath>
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

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

render::StageCost total(const render::FrameStatistics& s) {
    render::StageCost sum;
    for (const render::StageCost& stage : {s.plan, s.scene, s.warp, s.stars, s.display}) {
        sum.wall_ms += stage.wall_ms;
        sum.cpu_ms += stage.cpu_ms;
    }
    return sum;
}

/// Draws frames of one scenario and keeps what they cost.
class FrameBench {
  public:
    FrameBench(const content::Scenario& scenario, const PictureSize& size, int rounds, double sharpness)
        : scenario_(scenario), target_(size.width, size.height), rounds_(rounds),
          renderer_(content::load_scene(scenario), settings()) {
        frame_.eye.position = scenario.start_position;
        frame_.eye.horizontal_field_of_view = scenario.horizontal_field_of_view;
        frame_.eye.width = size.width;
        frame_.eye.height = size.height;
        frame_.exposure = {scenario.exposure.automatic, static_cast<float>(scenario.exposure.stops), false};
        frame_.sharpness = sharpness;
    }

    void print_header() const {
        fmt::print("{} {}x{}, sharpness {:.2f}, medians of {} interleaved pairs; ms of CPU time, all threads, plain "
                   "frame = same eye at rest\n",
                   scenario_.name, target_.width(), target_.height(), frame_.sharpness, rounds_);
        fmt::print("{:>5} {:7} {:>7} {:>7} {:>6} {:>8} | {:>6} {:>6} {:>6} {:>6} {:>7} | {:>5} {:>9} {:>9}\n", "beta",
                   "view", "plain", "moving", "ratio", "wall ms", "plan", "tiles", "warp", "stars", "display", "tiles",
                   "texels/px", "triangles");
    }

    /// One row: `turn` from the direction of looking to the direction of motion, as unit vectors of the eye's axes.
    void measure(double beta, const std::string& view, const glm::dvec3& heading_in_eye) {
        const glm::dvec3 look = glm::normalize(scenario_.start_look);
        const auto at_rest = sim::world_from_looking<sim::Head>(sim::Rapidity(0.0), look, look);
        const glm::dvec3 heading = (at_rest * sim::FourVector<sim::Head>{0.0, heading_in_eye}).space;
        const auto moving = sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), heading, look);
        std::vector<double> plain;
        std::vector<double> warped;
        std::vector<double> ratios;
        std::vector<double> walls;
        std::vector<std::array<double, 5>> stages;
        render::FrameStatistics last;
        for (int round = -1; round < rounds_; ++round) { // the first only warms up
            frame_.eye.world_from_head = at_rest;
            const double rest_ms = total(draw()).cpu_ms;
            frame_.eye.world_from_head = moving;
            last = draw();
            if (round < 0) {
                continue;
            }
            plain.push_back(rest_ms);
            warped.push_back(total(last).cpu_ms);
            walls.push_back(total(last).wall_ms);
            ratios.push_back(warped.back() / rest_ms);
            stages.push_back(
                {last.plan.cpu_ms, last.scene.cpu_ms, last.warp.cpu_ms, last.stars.cpu_ms, last.display.cpu_ms});
        }
        std::array<double, 5> stage_medians{};
        for (std::size_t i = 0; i < stage_medians.size(); ++i) {
            std::vector<double> values;
            for (const auto& round : stages) {
                values.push_back(round.at(i));
            }
            stage_medians.at(i) = median(values);
        }
        fmt::print("{:5.3f} {:7} {:7.1f} {:7.1f} {:6.2f} {:8.1f} | {:6.1f} {:6.1f} {:6.1f} {:6.1f} {:7.1f} | {:5} "
                   "{:9.2f} {:9}\n",
                   beta, view, median(plain), median(warped), median(ratios), median(walls), stage_medians[0],
                   stage_medians[1], stage_medians[2], stage_medians[3], stage_medians[4], last.tiles,
                   last.texels_per_pixel, last.triangles);
    }

  private:
    static render::RendererSettings settings() {
        render::RendererSettings settings;
        settings.measure_stages = true;
        return settings;
    }

    render::FrameStatistics draw() {
        return renderer_.draw(frame_, target_.framebuffer(), {0, 0, target_.width(), target_.height()});
    }

    content::Scenario scenario_;
    Offscreen target_;
    int rounds_;
    render::Renderer renderer_;
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

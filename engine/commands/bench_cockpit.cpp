#include "engine/cockpit/cockpit.h"
#include "engine/commands/bench.h"
#include "engine/median.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "render/gl/egl_context.h"
#include "render/gl/stage_clock.h"
#include "sim/look.h"

#include <cmath>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <vector>

namespace engine {
namespace {

struct Options {
    std::string scene = "street";
    std::string size = "1280x720";
    std::string rounds = "9";
};

void bench_cockpit(const Options& options) {
    const PictureSize size = size_option("--size", options.size);
    const int rounds = whole_number_option("--rounds", options.rounds, 1, 1000);
    const content::Scenario scenario = content::load_scenario(options.scene);
    const render::EglContext context;
    const render::Viewport viewport{0, 0, size.width, size.height};
    const Offscreen target(size.width, size.height);
    render::Renderer renderer(content::load_scene(scenario), {});
    render::RenderFrame frame;
    frame.eye.position = scenario.start_position;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(0.9)), scenario.start_look, scenario.start_look);
    frame.eye.horizontal_field_of_view = scenario.horizontal_field_of_view;
    frame.eye.width = size.width;
    frame.eye.height = size.height;
    frame.exposure = {scenario.exposure.automatic, static_cast<float>(scenario.exposure.stops), false};
    const sim::Lorentz<sim::World, sim::Vehicle> ship{frame.eye.world_from_head.spin};
    const render::CabinView view = cabin_view(frame.eye, {}, {1.0, 0.0, 0.0, 0.0});
    PictureSettings picture;
    ComfortSettings comfort;
    HudModel model;
    model.title = scenario.name;

    renderer.draw(frame, target.framebuffer(), viewport);
    render::StageClock clock(true);
    Cockpit cockpit(1.5F);
    const render::StageCost set_up = clock.lap();
    cockpit.light(renderer, frame, ship, {1.0, 0.0, 0.0, 0.0}, 0.0);
    const render::StageCost first_light = clock.lap();

    std::vector<double> pictures;
    std::vector<double> lights;
    std::vector<double> panels;
    std::vector<double> cabins;
    std::vector<double> shares;
    for (int round = -1; round < rounds; ++round) {
        clock.lap();
        const double stops = renderer.draw(frame, target.framebuffer(), viewport).exposure_stops;
        const double of_picture = clock.lap().cpu_ms;
        cockpit.light(renderer, frame, ship, {1.0, 0.0, 0.0, 0.0}, stops);
        const double of_light = clock.lap().cpu_ms;
        cockpit.panel().draw(model, picture, comfort, {}, false, 0.03);
        const double of_panel = clock.lap().cpu_ms;
        cockpit.draw(view, {stops}, target.framebuffer(), viewport);
        const double of_cabin = clock.lap().cpu_ms;
        if (round >= 0) { // the first warms up
            pictures.push_back(of_picture);
            lights.push_back(of_light);
            panels.push_back(of_panel);
            cabins.push_back(of_cabin);
            shares.push_back((of_light + of_panel + of_cabin) / of_picture);
        }
    }
    fmt::print("{} {}x{} at 0.9 c, medians of {} rounds; ms of CPU time, all threads\n"
               "picture without the cockpit        {:7.1f}\n"
               "light: {} small pictures, {} vertices {:5.1f}\n"
               "screens (15 times a second at most) {:6.1f}\n"
               "cabin, 4 samples a pixel           {:7.1f}\n"
               "all of the cockpit to the picture  {:7.2f}\n"
               "once: set-up {:.0f} (wall {:.0f}), first light {:.0f}\n",
               scenario.name, size.width, size.height, rounds, median(pictures), SceneryLight::views_a_frame,
               cockpit.cabin().mesh.vertices.size(), median(lights), median(panels), median(cabins), median(shares),
               set_up.cpu_ms, set_up.wall_ms, first_light.cpu_ms);
}

} // namespace

void add_bench_cockpit(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("cockpit", "what the cockpit costs on top of a picture");
    const auto options = std::make_shared<Options>();
    command->add_option("--scene", options->scene, "scenario")->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--rounds", options->rounds, "frames")->capture_default_str();
    command->callback([options] { bench_cockpit(*options); });
}

} // namespace engine

#include "engine/commands/bench.h"

#include "content/scenario.h"
#include "engine/fly/fly_options.h"
#include "engine/median.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "engine/vr/headset_ticks.h"
#include "input/xr_failure.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/gl/stage_clock.h"
#include "sim/look.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/core.h>
#include <memory>
#include <thread>
#include <vector>

namespace engine {
namespace {

using Clock = std::chrono::steady_clock;

struct Options {
    std::string scene;
    std::string size = "896x1007";
    std::string rounds = "9";
    std::string method;
};

/// Eyes 63 mm apart whose screens reach further outwards than past the nose.
input::XrEyes common_eyes() {
    input::XrEyes eyes;
    eyes[0] = {{{-0.0315, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)}, -1.1, 0.9, -1.1, 1.1};
    eyes[1] = {{{0.0315, 0.0, 0.0}, glm::dquat(1.0, 0.0, 0.0, 0.0)}, -0.9, 1.1, -1.1, 1.1};
    return eyes;
}

/// What stereo frames of one kind cost, round by round.
struct StereoCosts {
    std::vector<double> cpu;
    std::vector<double> wall;
    std::vector<double> gpu;
};

/// Draws both eyes of a ship, with what they share and without.
class StereoBench {
  public:
    StereoBench(const content::Scenario& scenario, const PictureSize& size, render::Method method)
        : scenario_(scenario),
          screens_(eye_screens(eyes_, size.width, size.height)), targets_{Offscreen(size.width, size.height),
                                                                          Offscreen(size.width, size.height)},
          renderer_(content::load_scene(scenario), {method}), timer_(render::Query::create(GLenum{GL_TIME_ELAPSED})) {}

    void measure(double beta, int rounds) {
        sim::VehicleState ship;
        ship.event.space = scenario_.start_position / scenario_.metres_per_light_unit();
        const glm::dvec3 look = glm::normalize(scenario_.start_look);
        ship.world_from_vehicle = sim::world_from_looking<sim::Vehicle>(sim::Rapidity(std::atanh(beta)), look, look);
        const std::array<render::EyeView, 2> views =
            eye_views(ship, {}, scenario_.metres_per_light_unit(), eyes_, screens_);
        StereoCosts alone;
        StereoCosts shared;
        for (int round = -1; round < rounds; ++round) {
            const bool counts = round >= 0; // the first only warms up
            draw(views, false, counts ? &alone : nullptr);
            draw(views, true, counts ? &shared : nullptr);
        }
        std::vector<double> ratios;
        for (std::size_t i = 0; i < alone.cpu.size(); ++i) {
            ratios.push_back(shared.cpu[i] / alone.cpu[i]);
        }
        const double pixels = static_cast<double>(views[1].width) * views[1].height;
        fmt::print("{:12} {:4.2f} | {:8.1f} {:8.1f} {:6.3f} | {:8.1f} {:8.1f} | {:8.1f} {:8.1f} | {:6.1f} %\n",
                   scenario_.name, beta, median(alone.cpu), median(shared.cpu), median(ratios), median(alone.wall),
                   median(shared.wall), median(alone.gpu), median(shared.gpu),
                   100.0 * static_cast<double>(share_.sky_reused) / pixels);
        std::fflush(stdout);
    }

  private:
    void draw(const std::array<render::EyeView, 2>& views, bool sharing, StereoCosts* costs) {
        render::StageClock clock(true);
        glBeginQuery(GL_TIME_ELAPSED, timer_.name());
        share_.begin(sharing ? whole_view(eyes_, views[0], screens_) : std::nullopt);
        for (std::size_t i = 0; i < views.size(); ++i) {
            render::RenderFrame frame;
            frame.eye = views.at(i);
            frame.exposure = {scenario_.exposure.automatic, static_cast<float>(scenario_.exposure.stops), false};
            frame.metres_per_light_year = scenario_.speed_of_light * 31557600.0;
            renderer_.draw(frame, targets_.at(i).framebuffer(), {0, 0, frame.eye.width, frame.eye.height}, &share_);
        }
        glEndQuery(GL_TIME_ELAPSED);
        const render::StageCost cost = clock.lap();
        if (costs != nullptr) {
            GLuint64 nanoseconds = 0;
            glGetQueryObjectui64v(timer_.name(), GL_QUERY_RESULT, &nanoseconds);
            costs->cpu.push_back(cost.cpu_ms);
            costs->wall.push_back(cost.wall_ms);
            costs->gpu.push_back(1e-6 * static_cast<double>(nanoseconds));
        }
    }

    content::Scenario scenario_;
    input::XrEyes eyes_ = common_eyes();
    std::array<EyeScreen, 2> screens_;
    std::array<Offscreen, 2> targets_;
    render::Renderer renderer_;
    render::StereoShare share_;
    render::Query timer_;
};

/// From when the head's place is asked for to when the pictures for it are handed over, in the headset that there is.
void measure_session(const content::Scenario& scenario, const PictureSize& size, render::Method method, int rounds) {
    try {
        Headset headset(input::XrBase::local, size);
        for (const std::string& note : headset.take_notes()) {
            fmt::print("{}\n", note);
        }
        render::Renderer renderer(content::load_scene(scenario), {method});
        const Flight flight(scenario, nullptr);
        const PictureSettings picture = starting_picture(scenario);
        const input::RoomScale scale{flight.metres_per_light_unit(), scenario.pace};
        std::vector<double> pose_to_submit;
        std::vector<double> between;
        const Clock::time_point deadline = Clock::now() + std::chrono::seconds(60);
        while (static_cast<int>(pose_to_submit.size()) < rounds && !headset.over() && Clock::now() < deadline) {
            const std::optional<HeadsetFrame> frame = headset.begin_frame();
            if (!frame) {
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
                continue;
            }
            headset.end_frame(renderer, flight, flight.state(), picture, scale, {}, frame->elapsed_seconds);
            if (frame->shown) {
                pose_to_submit.push_back(1e3 * headset.pose_to_submit_seconds());
                between.push_back(1e3 * frame->elapsed_seconds);
            }
        }
        headset.close();
        if (pose_to_submit.empty()) {
            fmt::print("pose to submit: the headset asks for no pictures\n");
            return;
        }
        fmt::print("{}: pose to submit {:.1f} ms, a frame every {:.1f} ms (medians of {})\n", scenario.name,
                   median(pose_to_submit), median(between), pose_to_submit.size());
    } catch (const input::XrFailure& failure) {
        fmt::print("pose to submit: not measured, no headset ({})\n", failure.what());
    }
}

void bench_vr(const Options& options) {
    const PictureSize size = size_option("--size", options.size);
    const int rounds = whole_number_option("--rounds", options.rounds, 1, 1000);
    const render::Method method = options.method.empty() ? render::Method::automatic
                                                         : named_option("--method", options.method, live_method_names);
    const std::vector<std::string> scenes = options.scene.empty()
                                                ? std::vector<std::string>{"street", "lattice", "city-sky", "stars"}
                                                : std::vector<std::string>{options.scene};
    const render::EglContext context;
    fmt::print(
        "stereo frames of {}x{} pixels an eye, medians of {} interleaved rounds, ms\n"
        "alone: each eye drawn for itself, exposed alike; shared: the sky's rays, the stars and the colours of D "
        "are found once for both eyes\n"
        "{:12} {:4} | {:^24} | {:^17} | {:^17} | of the second\n"
        "{:12} {:4} | {:>8} {:>8} {:>6} | {:>8} {:>8} | {:>8} {:>8} | eye, reused\n",
        size.width, size.height, rounds, "", "", "CPU, all threads", "wall", "GPU", "scene", "beta", "alone", "shared",
        "ratio", "alone", "shared", "alone", "shared");
    for (const std::string& scene : scenes) {
        const content::Scenario scenario = content::load_scenario(scene);
        StereoBench bench(scenario, size, method);
        bench.measure(0.0, rounds);
        bench.measure(0.9, rounds);
    }
    measure_session(content::load_scenario(scenes.front()), size, method, rounds);
}

} // namespace

void add_bench_vr(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("vr", "cost of stereo frames, and what both eyes share");
    const auto options = std::make_shared<Options>();
    command->add_option("--scene", options->scene, "scenario (default: street, lattice, city-sky, stars)");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels of an eye")->capture_default_str();
    command->add_option("--rounds", options->rounds, "pairs of stereo frames for each row")->capture_default_str();
    command->add_option("--method", options->method, "automatic, texture or ray");
    command->callback([options] { bench_vr(*options); });
}

} // namespace engine

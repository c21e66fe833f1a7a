#include "engine/commands/bench.h"

#include "engine/failure.h"
#include "render/gl/egl_context.h"
#include "render/gl/warp_error.h"
#include "sim/look.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace engine {
namespace {

constexpr double allowed_pixels = 0.1;
constexpr double allowed_relative_d = 1e-4;

void bench_warp() {
    const render::EglContext context;
    const std::array<std::pair<const char*, glm::dvec3>, 4> views{{{"ahead", {0.0, 0.0, -1.0}},
                                                                   {"behind", {0.0, 0.0, 1.0}},
                                                                   {"aside", {1.0, 0.0, 0.0}},
                                                                   {"oblique", {0.48, 0.6, -0.64}}}};
    fmt::print("GPU warp against double precision, every pixel of 1280x720 over 90 degrees; largest errors\n");
    fmt::print("{:>9} {:8} {:>12} {:>12}\n", "rapidity", "view", "pixels", "relative D");
    double worst_pixels = 0.0;
    double worst_d = 0.0;
    for (const double rapidity : {0.0, 0.1, 1.0, 2.0, 3.0, 5.0, 7.0, 10.0}) {
        for (const auto& [view, heading] : views) {
            render::EyeView eye;
            eye.world_from_head =
                sim::world_from_looking<sim::Head>(sim::Rapidity(rapidity), heading, {0.0, 0.0, -1.0});
            const render::WarpError error = render::warp_error(eye);
            fmt::print("{:9.1f} {:8} {:12.2e} {:12.2e}\n", rapidity, view, error.pixels, error.relative_d);
            worst_pixels = std::max(worst_pixels, error.pixels);
            worst_d = std::max(worst_d, error.relative_d);
        }
    }
    fmt::print("worst: {:.2e} px (allowed {}), D {:.2e} (allowed {})\n", worst_pixels, allowed_pixels, worst_d,
               allowed_relative_d);
    if (!(worst_pixels <= allowed_pixels && worst_d <= allowed_relative_d)) {
        throw Failure("the GPU's warp is less exact than allowed");
    }
}

} // namespace

void add_bench_warp(CLI::App& bench) {
    bench.add_subcommand("warp", "GPU warp against double precision, rapidity 0 to 10")->callback(bench_warp);
}

} // namespace engine

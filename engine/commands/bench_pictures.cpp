#include "content/scenario.h"
#include "engine/commands/bench.h"
#include "engine/method_comparison.h"
#include "engine/option_values.h"
#include "engine/picture_request.h"
#include "render/gl/egl_context.h"
#include "render/offline/compare.h"
#include "sim/look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <numbers>
#include <string_view>

namespace engine {
namespace {

struct PictureBench {
    std::vector<std::string> scenes{"lattice", "street"};
    std::vector<std::string> betas{"0", "0.5", "0.9", "0.99", "0.999"};
    std::string size = "1280x720";
    std::string samples = "4";
    std::string mode = "geometry";
    std::string method = "texture";
    std::string save; ///< folder for the pictures; "" to keep none
};

constexpr NamedValues<render::Method, 2> bench_method_names{
    {{"texture", render::Method::texture}, {"ray", render::Method::ray}}};

// Metres. At the start of the lattice whole columns of pixel centres look exactly along faces of beams, through slits
// without width that no sub-sample of the truth meets.
constexpr glm::dvec3 off_the_planes_of_symmetry{0.0137, 0.0071, 0.0113};

struct View {
    std::string_view name;
    glm::dvec3 look; ///< in the boosted axes
};

struct Worst {
    double edge = 0.0;
    double loss = -1e9; ///< dB by which the ordinary frame is nearer to its truth
};

render::RenderFrame frame_of(const PictureBench& bench, const content::Scenario& scenario, double beta,
                             const glm::dvec3& look) {
    render::RenderFrame frame;
    const PictureSize size = size_option("--size", bench.size);
    frame.eye.width = size.width;
    frame.eye.height = size.height;
    frame.eye.position = scenario.start_position + off_the_planes_of_symmetry;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), scenario.start_heading, look);
    frame.mode = named_option("--mode", bench.mode, mode_names);
    frame.exposure.automatic = true;
    frame.exposure.linear_curve = false;
    return frame;
}

void save_pictures(const std::string& folder, const std::string& name, const ComparedPictures& compared) {
    if (folder.empty()) {
        return;
    }
    const std::filesystem::path base = std::filesystem::path(folder) / name;
    render::write_png(base.string() + "_shown.png", compared.shown);
    render::write_png(base.string() + "_truth.png", compared.truth);
    render::write_png(base.string() + "_difference.png", render::difference_picture(compared.shown, compared.truth));
}

Worst bench_scene(const PictureBench& bench, const std::string& name, const std::vector<double>& betas, int samples) {
    const content::Scenario scenario = content::load_scenario(name);
    const content::SceneDesc scene = content::load_scene(scenario);
    const render::ReferenceRenderer reference(scene);
    const render::EglContext context;
    render::Renderer moving(scene, {named_option("--method", bench.method, bench_method_names)});
    render::Renderer plain(scene, {render::Method::plain});
    const glm::dvec3& heading = scenario.start_heading;
    const std::array<View, 3> views{
        {{"ahead", heading}, {"aside", sim::camera_axes(heading)[0]}, {"behind", -heading}}};
    Worst worst;
    for (const View& view : views) {
        const ComparedPictures ordinary =
            compare_with_reference(plain, reference, frame_of(bench, scenario, 0.0, view.look), samples);
        save_pictures(bench.save, fmt::format("{}_{}_ordinary", name, view.name), ordinary);
        for (const double beta : betas) {
            const ComparedPictures compared =
                compare_with_reference(moving, reference, frame_of(bench, scenario, beta, view.look), samples);
            save_pictures(bench.save, fmt::format("{}_{}_{}", name, view.name, beta), compared);
            const double loss = ordinary.signal_to_noise - compared.signal_to_noise;
            fmt::print("{:<9} {:<7} {:<7} {:8.2f} {:9.2f} {:+11.2f} {:10.2f} {:9.2f} {:9.2f} {:6}\n", name, beta,
                       view.name, compared.signal_to_noise, ordinary.signal_to_noise, -loss, compared.edge_displacement,
                       ordinary.edge_displacement, moving.statistics().texels_per_pixel, moving.statistics().tiles);
            std::fflush(stdout);
            worst.edge = std::max(worst.edge, compared.edge_displacement);
            worst.loss = std::max(worst.loss, loss);
        }
    }
    return worst;
}

void bench_pictures(const PictureBench& bench) {
    std::vector<double> betas;
    for (const std::string& text : bench.betas) {
        betas.push_back(number_option("--betas", text, 0.0, std::nextafter(1.0, 0.0)));
    }
    const int samples = whole_number_option("--samples", bench.samples, 1, 16);
    fmt::print("{0} against {1} x {1} rays a pixel; ordinary: one sample a pixel at rest against its own\n",
               bench.method, samples);
    fmt::print("{:<9} {:<7} {:<7} {:>8} {:>9} {:>11} {:>10} {:>9} {:>9} {:>6}\n", "scene", "beta", "view", "PSNR dB",
               "ordinary", "difference", "edge p99.9", "ordinary", "texels/px", "tiles");
    Worst worst;
    for (const std::string& name : bench.scenes) {
        const Worst of_scene = bench_scene(bench, name, betas, samples);
        worst = {std::max(worst.edge, of_scene.edge), std::max(worst.loss, of_scene.loss)};
    }
    fmt::print(
        "worst edge {:.2f} px (at most 0.5 wanted), worst loss against an ordinary frame {:.2f} dB (at most 1)\n",
        worst.edge, worst.loss);
}

} // namespace

void add_bench_pictures(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("pictures", "sharpness and edges of a live method against the truth");
    const auto settings = std::make_shared<PictureBench>();
    command->add_option("--scenes", settings->scenes, "scenarios (lattice,street)")->delimiter(',');
    command->add_option("--betas", settings->betas, "speeds (0,0.5,0.9,0.99,0.999)")->delimiter(',');
    command->add_option("--size", settings->size, "WIDTHxHEIGHT in pixels (1280x720)");
    command->add_option("--samples", settings->samples, "rays along each side of a pixel for the truth (4)");
    command->add_option("--mode", settings->mode, "geometry, doppler, searchlight or full (geometry)");
    command->add_option("--method", settings->method, "texture or ray (texture)");
    command->add_option("--save", settings->save, "folder to keep each pair of pictures and its difference in");
    command->callback([settings] { bench_pictures(*settings); });
}

} // namespace engine

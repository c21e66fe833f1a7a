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
#include <utility>

namespace engine {
namespace {

struct PictureBench {
    std::vector<std::string> scenes{"lattice", "street"};
    std::vector<std::string> betas{"0", "0.5", "0.9", "0.99", "0.999"};
    std::string size = "1280x720";
    std::string samples = "4";
    std::string mode = "geometry";
    std::string sharpness = "1.5";
    std::string save; ///< folder for the pictures; "" to keep none
};

struct View {
    std::string_view name;
    glm::dvec3 look; ///< in the boosted axes
};

/// The worst of one method's rows.
struct Worst {
    double edge = 0.0;
    double loss = -1e9; ///< dB by which the ordinary frame is nearer to its truth

    void take(const ComparedPictures& compared, double ordinary_signal_to_noise) {
        edge = std::max(edge, compared.edge_displacement);
        loss = std::max(loss, ordinary_signal_to_noise - compared.signal_to_noise);
    }
};

struct WorstOfMethods {
    Worst texture;
    Worst ray;
};

render::RenderFrame frame_of(const PictureBench& bench, const content::Scenario& scenario, double beta,
                             const glm::dvec3& look) {
    render::RenderFrame frame;
    const PictureSize size = size_option("--size", bench.size);
    frame.eye.width = size.width;
    frame.eye.height = size.height;
    frame.eye.position = scenario.start_position;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), scenario.start_heading, look);
    frame.mode = named_option("--mode", bench.mode, mode_names);
    frame.sharpness = number_option("--sharpness", bench.sharpness, 0.25, 2.0);
    frame.exposure.automatic = true;
    frame.exposure.linear_curve = false;
    return frame;
}

void save_pictures(const std::string& folder, const std::string& name, const ComparedPictures& compared,
                   const TrueView& truth) {
    if (folder.empty()) {
        return;
    }
    const std::filesystem::path base = std::filesystem::path(folder) / name;
    render::write_png(base.string() + "_shown.png", compared.shown);
    render::write_png(base.string() + "_truth.png", truth.light);
    render::write_png(base.string() + "_difference.png", render::difference_picture(compared.shown, truth.light));
}

void bench_scene(const PictureBench& bench, const std::string& name, const std::vector<double>& betas, int samples,
                 WorstOfMethods& worst) {
    const content::Scenario scenario = content::load_scenario(name);
    const content::SceneDesc scene = content::load_scene(scenario);
    const render::ReferenceRenderer reference(scene);
    const render::EglContext context;
    render::Renderer texture(scene, {render::Method::texture});
    render::Renderer ray(scene, {render::Method::ray});
    render::Renderer plain(scene, {render::Method::plain});
    const glm::dvec3& heading = scenario.start_heading;
    const std::array<View, 3> views{
        {{"ahead", heading}, {"aside", sim::camera_axes(heading)[0]}, {"behind", -heading}}};
    for (const View& view : views) {
        const TrueView at_rest = true_view(reference, frame_of(bench, scenario, 0.0, view.look), samples);
        const ComparedPictures ordinary = compare_with_truth(plain, at_rest);
        save_pictures(bench.save, fmt::format("{}_{}_ordinary", name, view.name), ordinary, at_rest);
        for (const double beta : betas) {
            const TrueView truth = true_view(reference, frame_of(bench, scenario, beta, view.look), samples);
            const ComparedPictures by_texture = compare_with_truth(texture, truth);
            const ComparedPictures by_ray = compare_with_truth(ray, truth);
            save_pictures(bench.save, fmt::format("{}_{}_{}_texture", name, view.name, beta), by_texture, truth);
            save_pictures(bench.save, fmt::format("{}_{}_{}_ray", name, view.name, beta), by_ray, truth);
            fmt::print("{:<9} {:<6} {:<7} | {:8.2f} {:5.2f} | {:8.2f} {:+7.2f} {:5.2f} {:5.2f} {:5} | {:8.2f} {:+7.2f} "
                       "{:5.2f}\n",
                       name, beta, view.name, ordinary.signal_to_noise, ordinary.edge_displacement,
                       by_texture.signal_to_noise, by_texture.signal_to_noise - ordinary.signal_to_noise,
                       by_texture.edge_displacement, texture.statistics().texels_per_pixel, texture.statistics().tiles,
                       by_ray.signal_to_noise, by_ray.signal_to_noise - ordinary.signal_to_noise,
                       by_ray.edge_displacement);
            std::fflush(stdout);
            worst.texture.take(by_texture, ordinary.signal_to_noise);
            worst.ray.take(by_ray, ordinary.signal_to_noise);
        }
    }
}

void bench_pictures(const PictureBench& bench) {
    std::vector<double> betas;
    for (const std::string& text : bench.betas) {
        betas.push_back(number_option("--betas", text, 0.0, std::nextafter(1.0, 0.0)));
    }
    const int samples = whole_number_option("--samples", bench.samples, 1, 16);
    fmt::print(
        "{0}, {1} mode, against {2} x {2} rays a pixel: PSNR in dB, and edges by object at the 99.9th percentile in "
        "px\ntexture: light and objects at sharpness {3}; ordinary: plain OpenGL at rest, one sample a pixel, "
        "against its own truth\n",
        bench.size, bench.mode, samples, bench.sharpness);
    fmt::print("{:<9} {:<6} {:<7} | {:>8} {:>5} | {:>8} {:>7} {:>5} {:>5} {:>5} | {:>8} {:>7} {:>5}\n", "scene", "beta",
               "view", "ordinary", "edge", "texture", "differs", "edge", "tx/px", "tiles", "ray", "differs", "edge");
    WorstOfMethods worst;
    for (const std::string& name : bench.scenes) {
        bench_scene(bench, name, betas, samples, worst);
    }
    for (const auto& [method, of_method] : {std::pair("texture", worst.texture), std::pair("ray", worst.ray)}) {
        fmt::print(
            "{}: worst edge {:.2f} px (at most 0.5 wanted), worst loss against an ordinary frame {:.2f} dB (at most "
            "1)\n",
            method, of_method.edge, of_method.loss);
    }
}

} // namespace

void add_bench_pictures(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("pictures", "sharpness and edges of the live methods against the truth");
    const auto settings = std::make_shared<PictureBench>();
    command->add_option("--scenes", settings->scenes, "scenarios (lattice,street)")->delimiter(',');
    command->add_option("--betas", settings->betas, "speeds (0,0.5,0.9,0.99,0.999)")->delimiter(',');
    command->add_option("--size", settings->size, "WIDTHxHEIGHT in pixels (1280x720)");
    command->add_option("--samples", settings->samples, "rays along each side of a pixel for the truth (4)");
    command->add_option("--mode", settings->mode, "geometry, doppler, searchlight or full (geometry)");
    command->add_option("--sharpness", settings->sharpness, "texels a pixel of the texture method (1.5, as stills)");
    command->add_option("--save", settings->save, "folder to keep each pair of pictures and its difference in");
    command->callback([settings] { bench_pictures(*settings); });
}

} // namespace engine

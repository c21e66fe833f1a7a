#include "engine/commands/bench.h"

#include "content/scenario.h"
#include "content/spectrum_data.h"
#include "engine/failure.h"
#include "engine/fly/fly_options.h"
#include "engine/median.h"
#include "engine/offscreen.h"
#include "engine/option_values.h"
#include "render/colour/colour_difference.h"
#include "render/colour/colour_space.h"
#include "render/colour/frame_colour_table.h"
#include "render/gl/egl_context.h"
#include "render/gl/renderer.h"
#include "render/offline/compare.h"
#include "render/offline/reference.h"
#include "render/offline/seen_colour.h"
#include "sim/look.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/core.h>
#include <glm/matrix.hpp>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace engine {
namespace {

struct Options {
    std::string scene = "street";
    std::string size = "640x360";
    std::string rounds = "7";
};

constexpr double allowed_error = 0.005;
constexpr double allowed_build_ms = 50.0;

double largest_component(const render::TermColumns& columns) {
    double largest = 0.0;
    for (const glm::dvec3& column : columns) {
        largest = std::max({largest, std::abs(column.r), std::abs(column.g), std::abs(column.b)});
    }
    return largest;
}

/// Milliseconds of CPU time, median of five, in which `work` is done.
template <class Work>
double median_cpu_ms(const Work& work) {
    std::vector<double> found;
    for (int round = 0; round < 5; ++round) {
        const std::clock_t start = std::clock();
        work();
        found.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return median(found);
}

/// Builds each scenario's tables by each model of reflectance, and of them those of a picture; a pilot shall not feel
/// it.
void bench_builds() {
    fmt::print("ms of CPU time (medians of 5) to build a scenario's tables, and those of one picture of them:\n{:12}",
               "");
    for (const char* model : content::reflectance_model_names) {
        fmt::print(" {:>20}", model);
    }
    fmt::print("\n");
    double longest = 0.0;
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        content::SceneDesc scene = content::load_scene(scenario);
        fmt::print("{:12}", scenario.name);
        for (std::size_t model = 0; model < content::reflectance_model_names.size(); ++model) {
            scene.reflectance_model = static_cast<content::ReflectanceModel>(model);
            const double build_ms = median_cpu_ms([&] { render::SceneColour{scene}; });
            const render::SceneColour colour(scene);
            const double frame_ms = median_cpu_ms(
                [&] { render::frame_colour_table(colour, render::Mode::full, 1.0 / 4.36, 4.36, 1.0); }); // 0.9 c
            fmt::print(" {:14.1f} {:5.2f}", build_ms, frame_ms);
            longest = std::max(longest, build_ms);
        }
        const render::SceneSpectra spectra(scene);
        fmt::print("   {} lights, {} kinds of surface\n", spectra.lights().size(), spectra.surfaces().size());
    }
    if (longest > allowed_build_ms) {
        throw Failure(fmt::format("tables took {:.1f} ms to build; {:.0f} ms are allowed", longest, allowed_build_ms));
    }
}

void bench_tables(const content::SceneDesc& scene) {
    const render::SceneColour colour(scene);
    const render::SceneSpectra& spectra = colour.spectra();
    const render::SpectralColour truth(spectra);
    constexpr double seen_share = 1e-6; // of the white at rest: an eye adapted to that does not see less
    double worst = 0.0;
    double worst_ratio = 1.0;
    std::size_t compared = 0;
    for (std::size_t group = 0; group < spectra.groups().size(); ++group) {
        for (double ln_ratio = std::log(0.01); ln_ratio < std::log(20.0); ln_ratio += 0.0137) {
            const auto table = colour.columns(group, render::Mode::full, ln_ratio);
            const auto exact = truth.columns(group, render::Mode::full, std::exp(ln_ratio));
            const double scale = largest_component(exact);
            if (scale < seen_share) {
                continue;
            }
            ++compared;
            render::TermColumns difference{};
            for (std::size_t i = 0; i < difference.size(); ++i) {
                difference.at(i) = table.at(i) - exact.at(i);
            }
            const double error = largest_component(difference) / scale;
            if (error > worst) {
                worst = error;
                worst_ratio = std::exp(ln_ratio);
            }
        }
    }
    fmt::print(
        "largest error of the tables of {} against sums over 471 wavelengths, D 0.01 to 20 where a term shows ({} "
        "compared): {:.4f} % at D = {:.3f}\n",
        scene.name, compared, 100.0 * worst, worst_ratio);
    if (worst > allowed_error) {
        throw Failure(fmt::format("a table is {:.2f} % off; {} % is allowed", 100.0 * worst, 100.0 * allowed_error));
    }
}

/// Pictures of every scenario from rapidity ln 20, ahead and aside, by the tables and by whole spectra on the same
/// rays.
void bench_scenarios() {
    fmt::print(
        "pictures by tables against sums over 471 wavelengths at every ray, D 0.05 to 20: CIEDE2000 mean, 99 %\n");
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        const content::SceneDesc scene = content::load_scene(scenario);
        const render::ReferenceRenderer reference(scene);
        std::vector<double> all;
        for (const glm::dvec3& look : {scenario.start_heading, -scenario.start_heading, glm::dvec3(1.0, 0.0, 0.0)}) {
            render::RenderFrame frame;
            frame.eye.position = scenario.start_position;
            frame.eye.world_from_head =
                sim::world_from_looking<sim::Head>(sim::Rapidity(std::log(20.0)), scenario.start_heading, look);
            frame.eye.width = 48;
            frame.eye.height = 27;
            frame.metres_per_light_year = scenario.speed_of_light * 31557600.0;
            const std::vector<double> found =
                render::colour_differences(reference.render(frame, 1, render::SpectralSums::tables),
                                           reference.render(frame, 1, render::SpectralSums::each_ray));
            all.insert(all.end(), found.begin(), found.end());
        }
        std::sort(all.begin(), all.end());
        const double mean = std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
        const double most = all[all.size() * 99 / 100];
        fmt::print("{:12} {:.4f} {:.4f}\n", scenario.name, mean, most);
        if (mean > 0.5 || most > 2.0) {
            throw Failure("pictures by tables differ from the spectra's: 0.5 in the mean and 2 at 99 % are allowed");
        }
    }
}

/// A matte material of one model, by which RGB reflectances get their spectra.
class ModelUnderTest {
  public:
    explicit ModelUnderTest(content::ReflectanceModel model) : colour_(scene_of(model)) {}

    glm::dvec3 seen(const glm::dvec3& reflectance, double ratio) const {
        const render::SceneSpectra& spectra = colour_.spectra();
        const render::MaterialTerms& material = spectra.materials().front();
        return colour_.seen(material.reflected, spectra.reflected(material, reflectance, glm::dvec3(1.0)),
                            render::Mode::full, std::log(ratio));
    }
    const glm::dmat3& rgb_from_xyz() const { return colour_.doppler().white().rgb_from_xyz(); }

  private:
    static content::SceneDesc scene_of(content::ReflectanceModel model) {
        content::SceneDesc scene;
        scene.materials.emplace_back();
        scene.reflectance_model = model;
        return scene;
    }
    render::SceneColour colour_;
};

/// Adapted linear RGB of a reflectance under the scene's light at D, white at rest 1.
glm::dvec3 true_rgb(const render::Observer& observer, const glm::dmat3& rgb_from_xyz,
                    const content::TabulatedSpectrum& reflectance, double ratio) {
    constexpr double kelvin = 5762.0;
    const double white_y = observer.xyz([&](double nm) { return content::black_body_radiance(nm, kelvin); }).y;
    return rgb_from_xyz * (observer.xyz([&](double nm) {
               return reflectance.at(nm / ratio) * content::black_body_radiance(nm, kelvin / ratio);
           }) / white_y);
}

void bench_models() {
    const render::Observer observer;
    const std::vector<content::TabulatedSpectrum> colours = content::cie_test_colours();
    content::TabulatedSpectrum white = colours.front();
    std::fill(white.values.begin(), white.values.end(), 1.0);
    fmt::print("the CIE's {} test colours from their RGB, under 5762 K: CIEDE2000 mean, 95th percentile, worst. They "
               "are measured from 360 to 830 nm and held beyond: below D = 0.9 the infrared is a guess.\n",
               colours.size());
    fmt::print("{:20}", "D");
    const std::array<double, 6> ratios{0.8, 0.85, 0.9, 0.95, 1.05, 1.1};
    for (const double ratio : ratios) {
        fmt::print(" {:>16.2f}", ratio);
    }
    fmt::print("\n");
    for (std::size_t model = 0; model < content::reflectance_model_names.size(); ++model) {
        const ModelUnderTest tested(static_cast<content::ReflectanceModel>(model));
        const glm::dmat3 xyz_from_rgb = glm::inverse(render::srgb_from_xyz());
        fmt::print("{:20}", content::reflectance_model_names.at(model));
        for (const double ratio : ratios) {
            const double white_light = content::luminance_of(true_rgb(observer, tested.rgb_from_xyz(), white, ratio));
            std::vector<double> differences;
            double sum = 0.0;
            for (const content::TabulatedSpectrum& colour : colours) {
                const glm::dvec3 rgb = glm::clamp(true_rgb(observer, tested.rgb_from_xyz(), colour, 1.0),
                                                  glm::dvec3(0.0), glm::dvec3(1.0));
                const auto lab = [&](const glm::dvec3& seen) {
                    return render::lab_from_xyz(xyz_from_rgb * seen / white_light);
                };
                differences.push_back(render::ciede2000(lab(tested.seen(rgb, ratio)),
                                                        lab(true_rgb(observer, tested.rgb_from_xyz(), colour, ratio))));
                sum += differences.back();
            }
            std::sort(differences.begin(), differences.end());
            fmt::print(" {:4.1f} {:5.1f} {:5.1f}", sum / static_cast<double>(differences.size()),
                       differences[differences.size() * 95 / 100], differences.back());
        }
        fmt::print("\n");
    }
}

/// Milliseconds of CPU time, all threads, that a frame takes.
double frame_ms(render::Renderer& renderer, const render::RenderFrame& frame, const Offscreen& target) {
    const std::clock_t start = std::clock();
    renderer.draw(frame, target.framebuffer(), {0, 0, target.width(), target.height()});
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// What comes after the light: exposure, tone curve, encoding; and glare.
void bench_display(render::Renderer& renderer, render::RenderFrame frame, const Offscreen& target, int rounds) {
    const render::Viewport viewport{0, 0, target.width(), target.height()};
    std::vector<double> plain;
    std::vector<double> glare;
    for (int round = -1; round < rounds; ++round) {
        frame.display.bloom = 0.0f;
        const double plain_ms = renderer.draw(frame, target.framebuffer(), viewport).display.cpu_ms;
        frame.display.bloom = 0.1f;
        const double glare_ms = renderer.draw(frame, target.framebuffer(), viewport).display.cpu_ms;
        if (round >= 0) {
            plain.push_back(plain_ms);
            glare.push_back(glare_ms);
        }
    }
    fmt::print("exposure and display of {}x{}: {:.1f} ms of CPU time, with glare {:.1f}\n", target.width(),
               target.height(), median(plain), median(glare));
}

void bench_frames(const content::Scenario& scenario, const content::SceneDesc& scene, const PictureSize& size,
                  int rounds, render::Method method) {
    const render::EglContext context;
    const Offscreen target(size.width, size.height);
    render::RendererSettings settings;
    settings.method = method;
    settings.measure_stages = true; // waits for OpenGL, so that the clock sees the work
    render::Renderer renderer(scene, settings);
    render::RenderFrame frame;
    frame.eye.position = scenario.start_position;
    frame.eye.width = size.width;
    frame.eye.height = size.height;
    frame.exposure = {scenario.exposure.automatic, static_cast<float>(scenario.exposure.stops), false};
    bench_display(renderer, frame, target, rounds);
    fmt::print("cost of full colour against geometry only, {} {}x{} by {}, ms of CPU time, medians of {} interleaved "
               "pairs\n",
               scenario.name, size.width, size.height, drawn_method_name(method), rounds);
    for (const double beta : {0.5, 0.9}) {
        frame.eye.world_from_head = sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)),
                                                                       scenario.start_heading, scenario.start_look);
        std::vector<double> plain;
        std::vector<double> full;
        std::vector<double> ratios;
        for (int round = -1; round < rounds; ++round) { // the first only warms up
            frame.mode = render::Mode::geometry;
            const double geometry_ms = frame_ms(renderer, frame, target);
            frame.mode = render::Mode::full;
            const double full_ms = frame_ms(renderer, frame, target);
            if (round >= 0) {
                plain.push_back(geometry_ms);
                full.push_back(full_ms);
                ratios.push_back(full_ms / geometry_ms);
            }
        }
        fmt::print("beta {:.2f}: geometry {:.1f}, full {:.1f}, ratio {:.3f}\n", beta, median(plain), median(full),
                   median(ratios));
    }
}

void bench_colour(const Options& options) {
    const PictureSize size = size_option("--size", options.size);
    const int rounds = whole_number_option("--rounds", options.rounds, 1, 1000);
    const content::Scenario scenario = content::load_scenario(options.scene);
    const content::SceneDesc scene = content::load_scene(scenario);
    bench_builds();
    bench_tables(scene);
    bench_scenarios();
    bench_models();
    for (const render::Method method : {render::Method::ray, render::Method::texture}) {
        bench_frames(scenario, scene, size, rounds, method);
    }
}

} // namespace

void add_bench_colour(CLI::App& bench) {
    CLI::App* command =
        bench.add_subcommand("colour", "colour tables: build time, error; spectral models; cost of full colour");
    const auto options = std::make_shared<Options>();
    command->add_option("--scene", options->scene, "scenario")->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels of the frames")->capture_default_str();
    command->add_option("--rounds", options->rounds, "pairs of frames for each row")->capture_default_str();
    command->callback([options] { bench_colour(*options); });
}

} // namespace engine

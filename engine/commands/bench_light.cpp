#include "engine/commands/bench.h"

#include "engine/failure.h"
#include "render/colour/star_photometry.h"
#include "render/eye_ray.h"
#include "render/offline/reference.h"
#include "render/picture_file.h"
#include "render/shown_picture.h"
#include "sim/bad_input.h"
#include "sim/look.h"

#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

/// What relativity says about the light of a moving eye's pictures, each against its closed form.
namespace engine {
namespace {

constexpr double sun_kelvin = 5762.0;
constexpr double single_precision = 3e-6; // pictures are floats; sums of a few of them

/// Prints a line and remembers whether anything was beyond its tolerance.
class Checks {
  public:
    void check(const std::string& what, double largest_error, double tolerance) {
        const bool holds = largest_error <= tolerance;
        fmt::print("{:78} {:9.2e}  (allowed {:.0e}){}\n", what, largest_error, tolerance, holds ? "" : "  FAILS");
        failed_ = failed_ || !holds;
    }
    bool failed() const { return failed_; }

  private:
    bool failed_ = false;
};

render::RenderFrame frame_of(double beta, const glm::dvec3& look, render::Mode mode, double field_of_view, int pixels) {
    render::RenderFrame frame;
    frame.eye.world_from_head =
        sim::world_from_looking<sim::Head>(sim::Rapidity(std::atanh(beta)), glm::dvec3(0.0, 0.0, -1.0), look);
    frame.eye.horizontal_field_of_view = field_of_view;
    frame.eye.width = pixels;
    frame.eye.height = pixels;
    frame.mode = mode;
    return frame;
}

glm::dvec3 looking(double degrees_from_heading) {
    const double angle = degrees_from_heading * std::numbers::pi / 180.0;
    return {std::sin(angle), 0.0, -std::cos(angle)};
}

/// D in the middle of a picture.
double wavelength_ratio(const render::RenderFrame& frame) {
    return sim::see(frame.eye.world_from_head,
                    render::head_direction_from_pixel(frame.eye, 0.5 * frame.eye.width, 0.5 * frame.eye.height))
        .wavelength_ratio;
}

content::SceneDesc uniform_sky(float radiance) {
    content::SceneDesc scene;
    scene.gradient_sky = {glm::vec3(radiance), glm::vec3(radiance), glm::vec3(radiance)};
    return scene;
}

/// The sun as a ball of 32 facets around, far enough that the eye sees all of it in 20 degrees; where it must stand to
/// be seen in the middle of the frame's picture.
content::SceneDesc sun_seen_by(const render::RenderFrame& frame) {
    content::SceneDesc scene = uniform_sky(0.0f);
    content::Material material;
    material.emission = glm::vec3(1.0f);
    material.emission_temperature = static_cast<float>(sun_kelvin);
    scene.materials.push_back(material);
    content::Mesh mesh;
    constexpr std::uint32_t columns = 64;
    constexpr std::uint32_t rows = 32;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double theta = std::numbers::pi * row / rows;
            const double phi = 2.0 * std::numbers::pi * column / columns;
            content::Vertex vertex;
            vertex.normal = glm::vec3(
                glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)));
            vertex.position = vertex.normal;
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t upper = row * (columns + 1) + column;
            const std::uint32_t lower = upper + columns + 1;
            mesh.indices.insert(mesh.indices.end(), {upper, lower, upper + 1, upper + 1, lower, lower + 1});
        }
    }
    scene.meshes.push_back(std::move(mesh));
    const glm::dvec3 direction =
        sim::see(frame.eye.world_from_head,
                 render::head_direction_from_pixel(frame.eye, 0.5 * frame.eye.width, 0.5 * frame.eye.height))
            .world_direction;
    content::Instance instance;
    instance.world_from_mesh[3] = glm::vec4(glm::vec3(12.0 * direction), 1.0f);
    scene.instances.push_back(instance);
    return scene;
}

glm::dvec3 middle_of(const render::Picture& picture) {
    const std::size_t at = 3 * (static_cast<std::size_t>(picture.height / 2) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(picture.width / 2));
    return {picture.values[at], picture.values[at + 1], picture.values[at + 2]};
}

/// The sun flies past at 0.5 c: by Planck's law at T/D, with and without the searchlight.
void bench_passing_sun(Checks& checks, const std::string& folder) {
    constexpr double beta = 0.5;
    constexpr int pixels = 129;
    const render::DopplerColour colour(sun_kelvin);
    const render::Observer observer;
    const render::LogXyz at_rest = observer.black_body(sun_kelvin);
    double worst_colour = 0.0;
    double worst_searchlight = 0.0;
    content::Image strip;
    const std::array<double, 7> angles{0.0, 30.0, 60.0, 90.0, 120.0, 150.0, 180.0};
    strip.width = static_cast<int>(angles.size()) * pixels;
    strip.height = 2 * pixels;
    strip.rgba.resize(4 * static_cast<std::size_t>(strip.width) * static_cast<std::size_t>(strip.height));
    fmt::print("the sun, {:.0f} K, passing at {} c, relative to its luminance at rest:\n", sun_kelvin, beta);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        render::RenderFrame frame = frame_of(beta, looking(angles.at(i)), render::Mode::full, 0.35, pixels);
        const content::SceneDesc scene = sun_seen_by(frame);
        const render::ReferenceRenderer reference(scene);
        const double ratio = wavelength_ratio(frame);
        const render::LogXyz seen = observer.black_body(sun_kelvin / ratio);
        const glm::dvec3 expected = std::exp(seen.ln_y - at_rest.ln_y) *
                                    (colour.white().rgb_from_xyz() * glm::dvec3(seen.x_over_y, 1.0, seen.z_over_y));
        const double scale = glm::length(expected);
        std::array<double, 2> luminances{};
        for (const bool searchlight : {false, true}) {
            frame.mode = searchlight ? render::Mode::full : render::Mode::doppler;
            const render::Picture picture = reference.render(frame, 1);
            const glm::dvec3 middle = middle_of(picture);
            const double factor = searchlight ? 1.0 : std::pow(ratio, 4.0);
            worst_colour = std::max(worst_colour, glm::length(middle / factor - expected) / scale);
            luminances.at(searchlight ? 1 : 0) = content::luminance_of(middle);
            const content::Image shown = render::shown_picture(picture, {false, -2.0f, false});
            for (int row = 0; row < pixels; ++row) {
                const auto from = shown.rgba.begin() + std::ptrdiff_t{4} * row * pixels;
                const int target_row = row + (searchlight ? pixels : 0);
                std::copy_n(from, std::ptrdiff_t{4} * pixels,
                            strip.rgba.begin() +
                                std::ptrdiff_t{4} * (target_row * strip.width + static_cast<int>(i) * pixels));
            }
        }
        worst_searchlight =
            std::max(worst_searchlight, std::abs(luminances[1] / luminances[0] * std::pow(ratio, 4.0) - 1.0));
        fmt::print(
            "  seen {:3.0f} degrees off the heading: D {:.4f}, {:6.0f} K; luminance {:9.5f} without, {:9.5f} with "
            "the searchlight\n",
            angles.at(i), ratio, sun_kelvin / ratio, luminances[0], luminances[1]);
    }
    checks.check("passing sun: colour and brightness against a black body of T/D", worst_colour, 1e-5);
    checks.check("passing sun: with the searchlight, D^-4 of what it is without", worst_searchlight, 1e-5);
    if (!folder.empty()) {
        const std::string file = folder + "/passing-sun.png";
        render::write_png(file, strip);
        fmt::print("  {}: above without, below with the searchlight, from 0 to 180 degrees\n", file);
    }
}

/// Total radiance of a white wall from a numerical sum over all wavelengths, D^-4; at one wavelength, D^-5.
void bench_wall(Checks& checks) {
    const content::Spectrum wall =
        content::Spectrum(content::SampledSpectrum{{555.0}, {1.0}, content::TabulatedSpectrum::Beyond::held}) *
        content::Spectrum(content::BlackBody{sun_kelvin});
    // Even steps in ln lambda from 10 nm to 3 mm: the integrand is smooth and vanishes at both ends.
    const auto total = [&](double ratio) {
        double sum = 0.0;
        for (double ln_nm = std::log(10.0); ln_nm < std::log(3e6); ln_nm += 0.002) {
            const double nm = std::exp(ln_nm);
            sum += nm * std::pow(ratio, -5.0) * wall.at(nm / ratio);
        }
        return sum;
    };
    const double at_rest = total(1.0);
    double worst_total = 0.0;
    double worst_spectral = 0.0;
    double worst_picture = 0.0;
    const content::SceneDesc white = uniform_sky(1.0f);
    const render::ReferenceRenderer reference(white);
    for (const double angle : {0.0, 45.0, 90.0, 135.0, 180.0}) {
        const render::RenderFrame frame = frame_of(0.9, looking(angle), render::Mode::searchlight, 0.01, 1);
        const double ratio = wavelength_ratio(frame);
        worst_total = std::max(worst_total, std::abs(total(ratio) / at_rest * std::pow(ratio, 4.0) - 1.0));
        // L'(D lambda) against L(lambda), by Planck's law at T/D.
        const double spectral = content::black_body_radiance(555.0 * ratio, sun_kelvin / ratio) /
                                content::black_body_radiance(555.0, sun_kelvin);
        worst_spectral = std::max(worst_spectral, std::abs(spectral * std::pow(ratio, 5.0) - 1.0));
        const double seen = middle_of(reference.render(frame, 1)).g;
        worst_picture = std::max(worst_picture, std::abs(seen * std::pow(ratio, 4.0) - 1.0));
    }
    checks.check("white wall at 0.9 c: total radiance, summed over wavelengths, D^-4", worst_total, 1e-6);
    checks.check("white wall at 0.9 c: spectral radiance at the shifted wavelength, D^-5", worst_spectral, 1e-12);
    checks.check("white wall at 0.9 c: the picture's radiance, D^-4", worst_picture, single_precision);
}

/// Flux of a star as the sum over the picture's pixels.
double star_flux(double beta, double angle, render::Mode mode, double& ratio) {
    constexpr double field_of_view = 0.02;
    const render::RenderFrame frame = frame_of(beta, looking(angle), mode, field_of_view, 33);
    const sim::SeenLight seen =
        sim::see(frame.eye.world_from_head, render::head_direction_from_pixel(frame.eye, 16.5, 16.5)); // the middle
    content::SceneDesc scene = uniform_sky(0.0f);
    content::Star star;
    star.position = 10.0 * seen.world_direction;
    star.temperature = 4000.0f;
    scene.stars.push_back(star);
    ratio = wavelength_ratio(frame);
    const render::Picture picture = render::ReferenceRenderer(scene).render(frame, 1);
    const double pixel = 2.0 * std::tan(0.5 * field_of_view) / frame.eye.width;
    double sum = 0.0;
    for (int row = 0; row < picture.height; ++row) {
        for (int column = 0; column < picture.width; ++column) {
            const std::size_t at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                                        static_cast<std::size_t>(column));
            const glm::dvec3 light(picture.values[at], picture.values[at + 1], picture.values[at + 2]);
            const double x = pixel * (column + 0.5 - 0.5 * picture.width);
            const double y = pixel * (row + 0.5 - 0.5 * picture.height);
            sum += content::luminance_of(light) * pixel * pixel * std::pow(1.0 + x * x + y * y, -1.5);
        }
    }
    return sum;
}

void bench_star(Checks& checks) {
    double worst_total = 0.0;
    double worst_visible = 0.0;
    double ratio = 1.0;
    const double at_rest = star_flux(0.0, 0.0, render::Mode::full, ratio);
    const render::Observer observer;
    const double rest_ln_y = observer.black_body(4000.0).ln_y;
    for (const double angle : {0.0, 60.0, 90.0, 150.0}) {
        const double total = star_flux(0.7, angle, render::Mode::searchlight, ratio) / at_rest;
        worst_total = std::max(worst_total, std::abs(total * ratio * ratio - 1.0));
        const double visible = star_flux(0.7, angle, render::Mode::full, ratio) / at_rest;
        const double expected = ratio * ratio * std::exp(observer.black_body(4000.0 / ratio).ln_y - rest_ln_y);
        worst_visible = std::max(worst_visible, std::abs(visible / expected - 1.0));
    }
    // A pixel's solid angle varies by 1e-5 over the star's footprint.
    checks.check("star at 0.7 c: flux summed over pixels, D^-2", worst_total, 3e-5);
    // The eye's adaptation makes luminance of RGB differ from Y by the hue; it cancels but for the shift of hue.
    checks.check("star at 0.7 c: visible flux, D^2 Y(T/D) / Y(T), Y before adaptation", worst_visible, 2e-2);
}

/// A uniform radiation field: mean radiance over the whole sky, gamma^2 (1 + beta^2 / 3).
void bench_whole_sky(Checks& checks) {
    const content::SceneDesc scene = uniform_sky(1.0f);
    const render::ReferenceRenderer reference(scene);
    constexpr int pixels = 128;
    double worst = 0.0;
    for (const double beta : {0.1, 0.5, 0.9}) {
        double sum = 0.0;
        double solid_angle = 0.0;
        for (const glm::dvec3& look : {glm::dvec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
            const render::Picture picture =
                reference.render(frame_of(beta, look, render::Mode::searchlight, 0.5 * std::numbers::pi, pixels), 4);
            for (int row = 0; row < pixels; ++row) {
                for (int column = 0; column < pixels; ++column) {
                    const double x = (2.0 * column + 1.0) / pixels - 1.0;
                    const double y = (2.0 * row + 1.0) / pixels - 1.0;
                    const double pixel = 4.0 / pixels / pixels * std::pow(1.0 + x * x + y * y, -1.5);
                    solid_angle += pixel;
                    sum += pixel *
                           static_cast<double>(picture.values[3 * static_cast<std::size_t>(row * pixels + column)]);
                }
            }
        }
        const double expected = (1.0 + beta * beta / 3.0) / (1.0 - beta * beta);
        fmt::print("  uniform field at {} c: mean over the sky {:.6f}, closed form {:.6f}\n", beta, sum / solid_angle,
                   expected);
        worst = std::max(worst, std::abs(sum / solid_angle / expected - 1.0));
    }
    // Midpoint sums over pixels of 0.9 degrees: second order in their size.
    checks.check("whole sky of a uniform field: gamma^2 (1 + beta^2 / 3)", worst, 2e-4);
}

void bench_light(const std::string& folder) {
    if (!folder.empty() && !std::filesystem::is_directory(folder)) {
        throw sim::BadInput("--pictures", "", folder, "must be an existing folder");
    }
    Checks checks;
    bench_passing_sun(checks, folder);
    bench_wall(checks);
    bench_star(checks);
    bench_whole_sky(checks);
    if (checks.failed()) {
        throw Failure("light is not as the closed forms say");
    }
}

} // namespace

void add_bench_light(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand("light", "radiance, flux and whole-sky sums against closed forms");
    const auto folder = std::make_shared<std::string>();
    command->add_option("--pictures", *folder, "an existing folder for the picture of the passing sun");
    command->callback([folder] { bench_light(*folder); });
}

} // namespace engine

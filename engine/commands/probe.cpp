#include "engine/commands/commands.h"
#include "engine/commands/eye_options.h"
#include "engine/csv_output.h"
#include "engine/gnuplot.h"
#include "engine/probe_plot.h"
#include "engine/probe_text.h"
#include "sim/bad_input.h"

#include <cmath>
#include <cstdio>
#include <fmt/core.h>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace engine {
namespace {

struct ProbeOptions {
    PictureOptions eye;
    std::string pixel;
    std::string csv;
    std::string plot;
};

bool is_visible(double nm) {
    return nm >= first_visible_nm && nm <= last_visible_nm;
}

void print_spectrum(const render::ProbedLight& light) {
    fmt::print("{:>12} {:>12} {:>12}\n", "nm", "emitted", "received");
    constexpr int rows = 40;
    for (int i = 0; i <= rows; ++i) {
        const double nm = 100.0 * std::pow(100.0, static_cast<double>(i) / rows); // to 10 um
        fmt::print("{:12.1f} {:12.4e} {:12.4e}{}\n", nm, light.emitted(nm), light.received(nm),
                   is_visible(nm) ? "  visible" : "");
    }
}

void write_spectrum(const std::string& file, const render::ProbedLight& light) {
    CsvOutput table;
    table.header = {"wavelength_nm", "emitted_relative", "received_relative", "visible"};
    constexpr double last_nm = 12000.0;
    for (double nm = 40.0; nm <= last_nm; nm += nm < 1000.0 ? 5.0 : 50.0) {
        table.rows.push_back({exact_text(nm), exact_text(light.emitted(nm)), exact_text(light.received(nm)),
                              is_visible(nm) ? "1" : "0"});
    }
    write_csv(file, table);
    fmt::print("{}: {} wavelengths\n", file, table.rows.size());
}

void probe(const ProbeOptions& options) {
    const PictureRequest request = picture_request(options.eye);
    const render::EyeView& eye = request.frame.eye;
    const std::vector<double> pixel = numbers_option("--pixel", options.pixel, 2);
    if (pixel[0] < 0.0 || pixel[0] > eye.width || pixel[1] < 0.0 || pixel[1] > eye.height) {
        throw sim::BadInput("--pixel", "", options.pixel,
                            fmt::format("must lie in the picture, {}x{} pixels", eye.width, eye.height));
    }
    const content::SceneDesc scene = content::load_scene(request.scenario);
    for (const std::string& note : scene.notes) {
        fmt::print(stderr, "rapidity: note: {}\n", note);
    }
    const render::ProbedLight light = render::SpectrumProbe(scene).at(request.frame, {pixel[0], pixel[1]});
    for (const std::string& line : probe_lines(light)) {
        fmt::print("{}\n", line);
    }
    fmt::print("seen from the world's direction {:.6f} {:.6f} {:.6f}\n", light.world_direction.x,
               light.world_direction.y, light.world_direction.z);
    fmt::print("{}\n", radiance_unit(light));
    if (!options.csv.empty()) {
        write_spectrum(options.csv, light);
    }
    if (!options.plot.empty()) {
        if (!std::ofstream(options.plot)) { // gnuplot would say it in five lines
            throw sim::BadInput(options.plot, "", "", "cannot be written");
        }
        run_gnuplot(probe_plot_script(options.plot, light));
        fmt::print("{}: plot\n", options.plot);
    }
    if (options.csv.empty() && options.plot.empty()) {
        print_spectrum(light);
    }
}

} // namespace

void add_probe_command(CLI::App& application) {
    CLI::App* command =
        application.add_subcommand("probe", "the spectrum at a point of a picture, emitted and received");
    command->group("Pictures");
    const auto options = std::make_shared<ProbeOptions>();
    add_eye_options(*command, options->eye);
    command->add_option("--pixel", options->pixel, "x,y from the picture's left and upper edges")->required();
    command->add_option("--csv", options->csv, "write the spectrum as a table, 40 nm to 12 um, instead of printing it");
    command->add_option("--plot", options->plot, "draw both spectra as SVG (needs gnuplot)");
    command->callback([options] { probe(*options); });
}

} // namespace engine

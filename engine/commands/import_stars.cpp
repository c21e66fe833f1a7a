#include "engine/commands/commands.h"

#include "content/star_catalogue.h"
#include "engine/failure.h"

#include <algorithm>
#include <fmt/core.h>
#include <fstream>
#include <memory>

namespace engine {
namespace {

struct Options {
    std::string table;
    std::string output;
};

void import_stars(const Options& options) {
    const std::vector<content::Star> stars = content::import_star_table(options.table);
    const std::vector<std::uint8_t> bytes = content::star_catalogue_bytes(stars);
    std::ofstream file(options.output, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
        throw Failure(fmt::format("{} cannot be written", options.output));
    }
    const auto unknown =
        std::count_if(stars.begin(), stars.end(), [](const content::Star& star) { return !star.distance_known; });
    fmt::print("{}: {} stars, {} of them of unknown distance, {} bytes\n", options.output, stars.size(), unknown,
               bytes.size());
}

} // namespace

void add_import_stars_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("import-stars", "make a star catalogue from a table");
    command->group("Scenes");
    const auto options = std::make_shared<Options>();
    command
        ->add_option("table", options->table,
                     "CSV, plain or .gz: right_ascension_deg,declination_deg,parallax_mas,v_mag,b_minus_v")
        ->required();
    command->add_option("-o,--output", options->output, "the *.rstars file to write")->required();
    command->callback([options] { import_stars(*options); });
}

} // namespace engine

#include "content/generator/generate.h"
#include "content/generator/glb_writer.h"
#include "engine/commands/commands.h"
#include "sim/bad_input.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace engine {
namespace {

struct GenerateOptions {
    std::string name;
    std::string file;
};

void write_file(const std::string& file, const std::vector<std::uint8_t>& bytes) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.close();
    if (!stream) {
        throw sim::BadInput(file, "", "", "cannot be written");
    }
}

void generate(const GenerateOptions& options) {
    const content::SceneDesc scene = content::generator::generate_model(options.name);
    const std::vector<std::uint8_t> bytes = content::generator::glb_bytes(scene);
    write_file(options.file, bytes);
    std::size_t triangles = 0;
    for (const content::Instance& instance : scene.instances) {
        triangles += scene.meshes[instance.mesh].indices.size() / 3;
    }
    fmt::print("{}: {} triangles in {} instances of {} meshes, {} materials, {} images, {} lamps; {} bytes\n",
               options.file, triangles, scene.instances.size(), scene.meshes.size(), scene.materials.size(),
               scene.images.size(), scene.lamps.size(), bytes.size());
}

} // namespace

void add_generate_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("generate", "write a built-in model as glTF (.glb)");
    command->group("Scenes");
    const auto options = std::make_shared<GenerateOptions>();
    command
        ->add_option("model", options->name,
                     fmt::format("one of {}", fmt::join(content::generator::model_names(), ", ")))
        ->required();
    command->add_option("-o,--output", options->file, "the file, FILE.glb")->required();
    command->callback([options] { generate(*options); });
}

} // namespace engine

#include "engine/commands/commands.h"

#include <fmt/core.h>
#include <string>

namespace engine {

void add_version_command(CLI::App& application) {
    const std::string version = fmt::format("rapidity {}", RAPIDITY_VERSION);
    application.set_version_flag("--version", version, "print the program's version");
    CLI::App* command = application.add_subcommand("version", "print the program's version");
    command->group("About");
    command->callback([version] { fmt::print("{}\n", version); });
}

} // namespace engine

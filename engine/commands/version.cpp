#include "engine/commands/commands.h"

#include <fmt/core.h>

namespace engine {

void add_version_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("version", "print the program's version");
    command->group("About");
    command->callback([] { fmt::print("rapidity {}\n", RAPIDITY_VERSION); });
}

} // namespace engine

#include "engine/commands/commands.h"

#include "content/scenario.h"
#include "content/scenario_keys.h"

#include <fmt/core.h>
#include <memory>

namespace engine {
namespace {

void print_scenarios() {
    for (const content::Scenario& scenario : content::built_in_scenarios()) {
        fmt::print("{:<12} {}\n", scenario.name, scenario.title);
        for (const std::string& missing : content::missing_content(scenario)) {
            fmt::print("{:<12}   {}\n", "", missing);
        }
    }
}

void print_keys() {
    const content::Scenario defaults;
    for (const content::ScenarioKey& key : content::scenario_keys()) {
        const std::string range = content::range_text(key);
        fmt::print("{}: {}\n    {}{}default {}\n", key.name, key.meaning,
                   key.unit.empty() ? "" : fmt::format("unit {}; ", key.unit),
                   range.empty() ? "" : fmt::format("{}; ", range), content::value_text(key, defaults));
    }
    for (const content::BeaconKey& key : content::beacon_keys) {
        fmt::print("[[beacon]] {}: {}\n{}", key.name.substr(key.name.find('.') + 1), key.meaning,
                   key.unit.empty() ? "" : fmt::format("    unit {}\n", key.unit));
    }
}

} // namespace

void add_scenes_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("scenes", "list the scenarios that come with the program");
    command->group("Scenes");
    const auto keys = std::make_shared<bool>(false);
    command->add_flag("--keys", *keys, "print what a scenario's TOML may say: every key, its unit, range and default");
    command->callback([keys] { *keys ? print_keys() : print_scenarios(); });
}

} // namespace engine

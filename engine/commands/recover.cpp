#include "engine/commands/commands.h"
#include "engine/recording_recovery.h"

#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <string>

namespace engine {
namespace {

struct RecoverOptions {
    std::string file;
    std::string output;
};

void recover(const RecoverOptions& options) {
    std::filesystem::path rescued = options.output;
    if (rescued.empty()) {
        rescued = std::filesystem::path(options.file).replace_extension(".recovered.rapidity");
    }
    const Recovery recovery = recover_recording(options.file, rescued);
    fmt::print("{}: ticks {} to {}, proved by flying them again\n", rescued.string(), recovery.first,
               recovery.saved_until);
    for (const std::string& loss : recovery.losses) {
        fmt::print("not all there: {}\n", loss);
    }
    if (!recovery.head_poses_checked) {
        fmt::print("head poses of the last part are unchecked: only the ship's states prove it\n");
    }
    sim::Tick saved = recovery.saved_until;
    const auto tell_lost = [&saved](sim::Tick until) {
        if (saved < until) {
            fmt::print("lost: ticks {} to {}\n", saved + 1, until);
        }
    };
    for (const LaterPart& part : recovery.later) {
        tell_lost(part.first - 1);
        fmt::print("{}: ticks {} to {}, behind a hole; proved by flying from snapshot to snapshot, head poses "
                   "unchecked\n",
                   part.file.string(), part.first, part.saved_until);
        saved = part.saved_until;
    }
    tell_lost(recovery.known_until);
    if (recovery.later.empty() && saved == recovery.known_until) {
        fmt::print("nothing that the file tells of is lost\n");
    }
}

} // namespace

void add_recover_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("recover", "save what is sound of a damaged recording");
    command->group("Fly");
    const auto options = std::make_shared<RecoverOptions>();
    command->add_option("file", options->file, "the damaged recording; it stays as it is")->required();
    command->add_option("-o,--output", options->output, "the new recording (default: FILE.recovered.rapidity)");
    command->callback([options] { recover(*options); });
}

} // namespace engine

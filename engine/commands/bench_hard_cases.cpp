#include "engine/commands/bench.h"

#include "engine/failure.h"
#include "engine/option_values.h"
#include "engine/proof/hard_cases.h"

#include <cstdio>
#include <fmt/core.h>
#include <memory>
#include <string>

namespace engine {
namespace {

struct Options {
    std::string ticks = "100000000";
};

void bench_hard_cases(const Options& options) {
    const auto ticks = static_cast<sim::Tick>(whole_number_option("--ticks", options.ticks, 1, 2'000'000'000));
    fmt::print("{:<78} {:>9} {:>9}\n", "hard case: quantity compared with its closed form", "error", "allowed");
    int failed = 0;
    for (const HardCase& hard : hard_cases()) {
        fmt::print("{}\n", hard.name);
        std::fflush(stdout); // some take a while
        for (const HardCaseResult& result : hard.fly(ticks)) {
            const bool good = holds(result);
            failed += good ? 0 : 1;
            fmt::print("  {:<76} {:9.2e} {:9.1e}{}\n", result.quantity, result.measured, result.allowed,
                       good ? "" : "  NOT MET");
            fmt::print("    {}\n", result.reason);
        }
    }
    if (failed > 0) {
        throw Failure(fmt::format("{} of the hard cases' quantities are not within what is allowed", failed));
    }
}

} // namespace

void add_bench_hard_cases(CLI::App& bench) {
    CLI::App* command = bench.add_subcommand(
        "hard-cases", "flights that are hard on an integrator, against closed forms; exit 1 when one is off");
    const auto options = std::make_shared<Options>();
    command->add_option("--ticks", options->ticks, "of the long tumbling")->capture_default_str();
    command->callback([options] { bench_hard_cases(*options); });
}

} // namespace engine

#include "engine/commands/commands.h"

#include "sim/spacetime/spacetimes.h"

#include <fmt/core.h>

namespace engine {
namespace {

void print_spacetimes() {
    for (const sim::SpacetimeKind& kind : sim::spacetime_kinds()) {
        fmt::print("{:<20} {}\n    ds^2: {}\n    chart: {}\n    source: {}\n    limits: {}\n", kind.name, kind.title,
                   kind.line_element, kind.chart, kind.source, kind.limits);
        for (const sim::SpacetimeParameter& parameter : kind.parameters) {
            fmt::print("    --param {}={:g}: {}; {:g} to {:g}\n", parameter.name, parameter.standard, parameter.doc,
                       parameter.least, parameter.most);
        }
    }
    fmt::print("FILE.toml            a spacetime of your own, g_mu_nu as formulas of t, x, y, z:\n"
               "    name = \"...\", smallest_length = 1.0, flat_radius = 1e4, [parameters] M = 1.0,\n"
               "    [definitions] r = \"sqrt(x^2 + y^2 + z^2)\", [metric] tt = \"-1 + 2*M/r\", xx = \"...\", ...\n");
}

} // namespace

void add_spacetimes_command(CLI::App& application) {
    CLI::App* command = application.add_subcommand("spacetimes", "list the spacetimes that light can be traced in");
    command->group("Curved spacetime");
    command->callback(print_spacetimes);
}

} // namespace engine
